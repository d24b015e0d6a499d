"""Ten commands with tello-asyncio over a link that fails: each again until the drone has done it."""

import asyncio

from tello_asyncio import Tello

TRIES = 12
TIMEOUT_S = 4  # longer than any of the commands takes
PAUSE_S = 1  # for what is still on its way, or still being flown
LONGER_S = 0.3  # each time, or every try may come just before the drone has settled


class Impatient(Tello):
    """Waits less than the client's 10 s."""

    async def send(self, message, timeout=TIMEOUT_S, response_parser=None):
        return await super().send(message, timeout, response_parser)


class Flight:
    def __init__(self):
        self.drone = Impatient(on_error=self.refused)
        self.error = None

    def refused(self, drone, error):
        self.error = str(error)

    async def connect(self):
        """Connects anew, too: the client takes the next reply for the one that never came."""
        for i in range(TRIES):
            self.error = None
            try:
                await self.drone.connect()
            except TypeError:  # its own, where no number came to `battery?`
                pass
            if self.error is None:
                return
            await self.drone.disconnect()
            await asyncio.sleep(PAUSE_S + i * LONGER_S)
        raise SystemExit("no connection")

    async def persist(self, call, *arguments, done=lambda refusal: False):
        """Calls until the client reports success, or `done` says that the drone had done it before."""
        for i in range(TRIES):
            self.error = None
            await call(*arguments)
            if self.error is None or done(self.error):
                return
            error = self.error
            await self.drone.disconnect()
            await asyncio.sleep(PAUSE_S + i * LONGER_S)
            await self.connect()
            if call not in (self.drone.takeoff, self.drone.land) and "Motor stop" in error:
                await self.take_off()  # it has landed by itself, as nothing came for 15 s
        raise SystemExit(f"{call.__name__} {arguments} failed {TRIES} times")

    async def take_off(self):
        await self.persist(
            self.drone.takeoff, done=lambda refusal: self.drone.time_of_flight > 20
        )

    async def fly(self):
        drone = self.drone
        await self.connect()
        await self.take_off()
        await self.persist(drone.move_up, 30)
        await self.persist(drone.move_forward, 50)
        await self.persist(drone.turn_clockwise, 90)
        await self.persist(drone.move_left, 30)
        await self.persist(drone.move_right, 30)
        await self.persist(drone.turn_counterclockwise, 90)
        await self.persist(drone.move_back, 50)
        await self.persist(drone.land, done=lambda refusal: "Motor stop" in refusal)
        print("done", flush=True)


asyncio.get_event_loop().run_until_complete(Flight().fly())
