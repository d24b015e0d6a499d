"""Flies djitellopy.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import logging
import re
import sys
import time

from djitellopy import Tello, TelloException

from steps import Steps

STATE_FIELDS = (
    "mid x y z mpry pitch roll yaw vgx vgy vgz templ temph tof h bat baro time agx agy agz".split()
)

steps = Steps()


def connected(arguments):
    if not arguments:
        return Tello()
    drone = Tello(arguments[0])
    drone.address = (arguments[0], int(arguments[1]))
    return drone


def answer(call, *arguments):
    """The drone's reply: what the client returns, or what it quotes in its exception."""
    try:
        result = call(*arguments)
    except TelloException as refused:
        return re.search(r"Latest response:\t'(.*)'", str(refused), re.DOTALL).group(1)
    except ValueError as unreadable:
        return f"ValueError: {unreadable}"
    return "ok" if result in (None, True) else result


def fly(command, call, *arguments, **expected):
    expected = expected or {"want": "ok"}
    return steps.report(command, answer(call, *arguments), **expected)


def not_a_number(text):
    """Faithful: the client makes an int of whatever comes, and the drone sends units."""
    return {"pattern": r"ValueError: invalid literal for int\(\) with base 10: '" + text + "'"}


def reads(drone):
    fly("battery?", drone.query_battery, pattern=r"100|9\d")
    fly("sdk?", drone.query_sdk_version, want="20")
    fly("sn?", drone.query_serial_number, pattern="[0-9A-Z]{14}")
    fly("wifi?", drone.query_wifi_signal_noise_ratio, pattern="[0-9]{1,3}")
    fly("attitude?", drone.query_attitude, want={"pitch": 0, "roll": 0, "yaw": 0})
    fly("tof?", drone.query_distance_tof, pattern=r"\d+\.\d")
    fly("speed?", drone.query_speed, **not_a_number(r"100\.0"))
    fly("time?", drone.query_flight_time, **not_a_number("0s"))
    fly("height?", drone.query_height, **not_a_number("0dm"))
    fly("temp?", drone.query_temperature, **not_a_number(r"\d+~\d+C"))
    fly("baro?", drone.query_barometer, **not_a_number(r"-?\d+\.\d{6}"))


def state(drone, pose):
    time.sleep(0.3)
    fields = list(drone.get_current_state())
    steps.report("get_current_state()", " ".join(fields), " ".join(STATE_FIELDS))
    steps.report("get_battery()", drone.get_battery(), near=(pose.battery, 1))
    steps.report("get_height()", drone.get_height(), near=(pose.z, 10))
    steps.report("get_distance_tof()", drone.get_distance_tof(), near=(max(pose.z, 10), 2))
    steps.report("get_yaw()", drone.get_yaw(), near=(pose.yaw, 1))
    steps.report("get_flight_time()", drone.get_flight_time(), pattern=r"\d+")


def refusals_on_the_ground(drone):
    fly("up 50", drone.move_up, 50, want="error Motor stop")
    fly("land", drone.land, want="error Motor stop")
    fly("stop", drone.send_control_command, "stop", want="error")
    fly("hover", drone.send_control_command, "hover", want="unknown command: hover")


def moves(drone):
    fly("up 70", drone.move_up, 70)
    fly("forward 60", drone.move_forward, 60)
    fly("left 50", drone.move_left, 50)
    state(drone, fly("cw 90", drone.rotate_clockwise, 90))
    fly("back 40", drone.move_back, 40)
    fly("ccw 45", drone.rotate_counter_clockwise, 45)
    fly("right 30", drone.move_right, 30)
    fly("down 20", drone.move_down, 20)
    fly("speed 60", drone.set_speed, 60)
    fly("go -60 -40 30 60", drone.go_xyz_speed, -60, -40, 30, 60)
    fly("curve 60 60 0 120 0 0 60", drone.curve_xyz_speed, 60, 60, 0, 120, 0, 0, 60)
    fly("flip b", drone.flip_back)
    fly("flip l", drone.flip_left)


def refusals_in_the_air(drone):
    fly("takeoff", drone.takeoff, want="error")
    fly("forward 19", drone.move_forward, 19, want="out of range")
    fly("go 20 20 20 50", drone.go_xyz_speed, 20, 20, 20, 50, want="out of range")
    fly("flip x", drone.flip, "x", want="out of range")
    collinear = "curve 30 0 0 60 0 0 30"
    too_large = "error Radius is too large!"
    fly(collinear, drone.curve_xyz_speed, 30, 0, 0, 60, 0, 0, 30, want=too_large)


def pads(drone, time_passes):
    fly("mon", drone.enable_mission_pads)
    if time_passes:
        time.sleep(0.3)
        steps.report("get_mission_pad_id()", drone.get_mission_pad_id(), -1)
    pad_1 = "go 0 0 50 50 m1"
    fly(pad_1, drone.go_xyz_speed_mid, 0, 0, 50, 50, 1, want="error No valid marker")
    fly("moff", drone.disable_mission_pads)


def stick(drone):
    """Two simulated seconds backwards by stick, which nothing answers."""
    drone.send_rc_control(0, -50, 0, 0)
    time.sleep(0.4)
    drone.send_rc_control(0, 0, 0, 0)
    time.sleep(0.3)
    waiting = drone.get_own_udp_object()["responses"]
    steps.report("rc 0 -50 0 0, rc 0 0 0 0", waiting, want=[], free=("back", 20, 200))


def stop_on_the_way(drone):
    drone.send_command_without_return("back 200")
    time.sleep(0.3)
    reply = answer(drone.send_control_command, "stop")
    steps.report("back 200, stop", reply, want="ok", free=("back", 5, 150))
    second_answer(drone)


def second_answer(drone):
    """The late `forced stop`, which this client would take for the next command's reply."""
    late = drone.get_own_udp_object()["responses"]
    patience = time.monotonic() + 2
    while not late and time.monotonic() < patience:
        time.sleep(0.05)
    steps.report("(late answer to stop)", late, want=[b"forced stop"])
    late.clear()


def main():
    # At full speed, time stands still while the drone does: no state comes, and pauses are none.
    time_passes = "--at-full-speed" not in sys.argv
    drone = connected([word for word in sys.argv[1:] if not word.startswith("--")])
    drone.LOGGER.setLevel(logging.WARNING)
    state(drone, fly("command", drone.connect))
    reads(drone)
    refusals_on_the_ground(drone)
    fly("takeoff", drone.takeoff)
    moves(drone)
    refusals_in_the_air(drone)
    pads(drone, time_passes)
    if time_passes:
        stick(drone)
        stop_on_the_way(drone)
    else:
        fly("stop", drone.send_control_command, "stop")
        second_answer(drone)
    fly("streamon", drone.streamon)
    fly("streamoff", drone.streamoff)
    fly("down 300", drone.move_down, 300)
    drone.emergency()
    steps.report("emergency", drone.get_own_udp_object()["responses"], want=[])
    fly("takeoff", drone.takeoff)
    fly("forward 50", drone.move_forward, 50)
    fly("land", drone.land)
    print("done", flush=True)


main()
