"""Flies tello-asyncio.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import asyncio
import sys

from tello_asyncio import Direction, MissionPadDetection, Tello, Vector
from tello_asyncio.tello import CONTROL_UDP_PORT

from steps import Steps

steps = Steps()


def redirect(loop, port):
    """Sends commands to another port; the client binds and commands one and the same, 8889."""
    create = loop.create_datagram_endpoint

    async def create_elsewhere(protocol, local_addr=None, remote_addr=None):
        if remote_addr is not None and remote_addr[1] == CONTROL_UDP_PORT:
            remote_addr = (remote_addr[0], port)
        return await create(protocol, local_addr=local_addr, remote_addr=remote_addr)

    loop.create_datagram_endpoint = create_elsewhere


class Flight:
    def __init__(self, arguments):
        if arguments:
            redirect(asyncio.get_event_loop(), int(arguments[1]))
            self.drone = Tello(arguments[0], on_error=self.refused)
        else:
            self.drone = Tello(on_error=self.refused)
        self.error = None

    def refused(self, drone, error):
        self.error = error

    async def fly(self, command, coroutine, free=None, **expected):
        self.error = None
        result = await coroutine
        if self.error is not None:
            reply = str(self.error).removeprefix(f"[{command}] ERROR ")
        else:
            reply = "ok" if result is None else result
        expected = expected or {"want": "ok"}
        return steps.report(command, reply, free=free, **expected)

    async def state(self, pose):
        await asyncio.sleep(0.3)
        drone = self.drone
        steps.report("battery", drone.battery, near=(pose.battery, 1))
        steps.report("height", drone.height, near=(pose.z, 10))
        steps.report("time_of_flight", drone.time_of_flight, near=(max(pose.z, 10), 2))
        steps.report("yaw", drone.yaw, near=(pose.yaw, 1))
        steps.report("mission_pad", drone.mission_pad, want=-2)

    async def reads(self):
        drone = self.drone
        await self.fly("battery?", drone.query_battery(), pattern=r"100|9\d")
        await self.fly("speed?", drone.speed, want=100.0)
        await self.fly("sdk?", drone.sdk_version, want="20\r\n")
        await self.fly("sn?", drone.serial_number, pattern="[0-9A-Z]{14}")
        await self.fly("wifi?", drone.wifi_signal_to_noise_ratio, pattern="[0-9]{1,3}")
        time = drone.send("time?", response_parser=str)
        await self.fly("time?", time, want="0s\r\n")

    async def refusals_on_the_ground(self):
        drone = self.drone
        await self.fly("forward 50", drone.move_forward(50), want="error Motor stop")
        await self.fly("land", drone.land(), want="error Motor stop")
        await self.fly("Takeoff", drone.send("Takeoff"), want="unknown command: Takeoff")

    async def moves(self):
        drone = self.drone
        await self.fly("up 80", drone.move_up(80))
        await self.fly("forward 70", drone.move(Direction.FORWARD, 70))
        await self.fly("right 40", drone.move_right(40))
        await self.state(await self.fly("ccw 120", drone.turn_counterclockwise(120)))
        await self.fly("back 50", drone.move_back(50))
        await self.fly("cw 30", drone.turn_clockwise(30))
        await self.fly("left 60", drone.move_left(60))
        await self.fly("down 30", drone.move_down(30))
        await self.fly("speed 80", drone.set_speed(80))
        await self.fly("go 50 -50 40 70", drone.go_to(Vector(50, -50, 40), 70))
        via, end = Vector(25, -25, 0), Vector(25, -75, 0)
        await self.fly("curve 25 -25 0 25 -75 0 40", drone.curve_to(via, end, 40))
        await self.fly("flip r", drone.flip_right())
        await self.fly("flip f", drone.flip(Direction.FORWARD))

    async def refusals_in_the_air(self):
        drone = self.drone
        await self.fly("takeoff", drone.takeoff(), want="error")
        await self.fly("up 501", drone.move_up(501), want="out of range")
        below = drone.go_to(Vector(-10, 15, 0), 26)
        await self.fly("go -10 15 0 26", below, want="out of range")
        tight = drone.curve_to(Vector(20, 20, 21), Vector(30, 0, 30), 30)
        too_tight = "error Radius is too large!"
        await self.fly("curve 20 20 21 30 0 30 30", tight, want=too_tight)

    async def pads(self):
        drone = self.drone
        await self.fly("mon", drone.enable_mission_pads())
        both = drone.set_mission_pad_detection(MissionPadDetection.BOTH)
        await self.fly("mdirection 2", both)
        await asyncio.sleep(0.3)
        steps.report("mission_pad", drone.mission_pad, want=-1)
        unseen = drone.go_to(Vector(0, 0, 50), 50, mission_pad=3)
        await self.fly("go 0 0 50 50 m3", unseen, want="error No valid marker")
        await self.fly("moff", drone.disable_mission_pads())

    async def stick(self):
        await self.drone.remote_control(40, 0, 0, 0)
        await asyncio.sleep(0.4)
        centred = self.drone.remote_control(0, 0, 0, 0)
        await self.fly("rc 40 0 0 0, rc 0 0 0 0", centred, free=("right", 10, 200))

    async def run(self):
        drone = self.drone
        await self.state(await self.fly("command", drone.connect()))
        await self.reads()
        await self.refusals_on_the_ground()
        await self.fly("takeoff", drone.takeoff())
        await self.moves()
        await self.refusals_in_the_air()
        await self.pads()
        await self.stick()
        await self.fly("stop", drone.stop())
        await asyncio.sleep(0.3)
        await self.fly("back 40", drone.move_back(40))
        await self.fly("land", drone.land())
        await drone.disconnect()
        print("done", flush=True)


async def main():
    await Flight(sys.argv[1:]).run()


asyncio.run(main())
