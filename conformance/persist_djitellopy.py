"""Ten commands with djitellopy over a link that fails: each again until the drone has carried it out."""

import time

from djitellopy import Tello, TelloException

TRIES = 12
PAUSE_S = 2  # for what is still on its way, or still being flown
LONGER_S = 0.3  # each time, or every try may come just before the drone has settled

drone = Tello()


def state(field):
    return drone.get_current_state().get(field, 0)


def persist(call, *arguments, done=lambda refusal: False):
    """Calls until the client reports success, or `done` says that the drone had done it before."""
    for i in range(TRIES):
        drone.get_own_udp_object()["responses"].clear()
        try:
            call(*arguments)
            return
        except TelloException as refused:
            time.sleep(PAUSE_S + i * LONGER_S)
            if done(str(refused)):
                return
            if call not in (drone.connect, take_off, drone.land) and "Motor stop" in str(refused):
                take_off()  # it has landed by itself, as nothing came for 15 s
    raise SystemExit(f"{call.__name__} {arguments} failed {TRIES} times")


def take_off():
    persist(drone.takeoff, done=lambda refusal: state("tof") > 20)


persist(drone.connect)
take_off()
persist(drone.move_up, 30)
persist(drone.move_forward, 50)
persist(drone.rotate_clockwise, 90)
persist(drone.move_left, 30)
persist(drone.move_right, 30)
persist(drone.rotate_counter_clockwise, 90)
persist(drone.move_back, 50)
persist(drone.land, done=lambda refusal: "Motor stop" in refusal or state("tof") <= 10)
print("done", flush=True)
