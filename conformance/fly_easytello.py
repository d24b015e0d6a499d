"""Flies easytello, which always uses the address of a real drone."""

import ast

from easytello import Tello

from steps import Steps

steps = Steps()


def reply(drone):
    """Returns the last reply, which easytello keeps as the text of a bytes literal."""
    return ast.literal_eval(drone.log[-1].get_response()).decode()


def fly(command, call, *arguments, want="ok"):
    call(*arguments)
    return steps.report(command, reply(call.__self__), want=want)


def main():
    drone = Tello(debug=False)
    steps.report("command", reply(drone), want="ok")
    steps.report("battery?", drone.get_battery(), least=90)
    steps.report("tof?", drone.get_tof(), near=(100, 10))
    steps.report("speed?", drone.get_speed(), near=(100, 0))
    fly("up 50", drone.up, 50, want="error Motor stop")
    fly("takeoff", drone.takeoff)
    fly("up 70", drone.up, 70)
    fly("forward 60", drone.forward, 60)
    fly("cw 90", drone.cw, 90)
    fly("left 40", drone.left, 40)
    fly("back 30", drone.back, 30)
    fly("right 50", drone.right, 50)
    fly("ccw 45", drone.ccw, 45)
    fly("down 20", drone.down, 20)
    fly("speed 60", drone.set_speed, 60)
    fly("go 50 -40 30 60", drone.go, 50, -40, 30, 60)
    fly("flip l", drone.flip, "l")
    fly("forward 501", drone.forward, 501, want="out of range")
    fly("land", drone.land)
    print("done", flush=True)


main()
