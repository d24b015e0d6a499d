"""Flies easytello, which finds the drone where it always is."""

import time

from easytello import Tello

from steps import Steps

steps = Steps()


def fly(command, call, *arguments, **expected):
    drone = call.__self__
    call(*arguments)
    reply = drone.log[-1].get_response()
    return steps.report(command, reply, **(expected or {"want": "ok"}))


def main():
    drone = Tello(debug=False)
    steps.report("command", drone.log[-1].get_response(), want="ok")
    steps.report("battery?", drone.get_battery(), pattern=r"100\r\n|9\d\r\n")
    steps.report("tof?", drone.get_tof(), pattern=r"\d+mm\r\n")
    steps.report("speed?", drone.get_speed(), want="100.0\r\n")
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
    time.sleep(0.1)
    print("done", flush=True)


main()
