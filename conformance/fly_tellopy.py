"""Flies TelloPy, which speaks the binary protocol of the drone's app.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import sys
import threading
import time

import av
import tellopy

from steps import Steps

PICTURES = 200
PICTURES_WITHIN_S = 12

steps = Steps()


class Latest:
    """What the drone has told last, and how often."""

    def __init__(self, drone):
        self.flight, self.log, self.flights = None, None, 0
        drone.subscribe(drone.EVENT_FLIGHT_DATA, self.flown)
        drone.subscribe(drone.EVENT_LOG_DATA, self.logged)

    def flown(self, event, sender, data, **_):
        self.flight = data
        self.flights += 1

    def logged(self, event, sender, data, **_):
        self.log = data


def watch(drone, seen):
    """Decodes the video with FFmpeg's library, as TelloPy's own examples do."""
    container = av.open(drone.get_video_stream())
    for picture in container.decode(video=0):
        seen.append((picture.width, picture.height))


def await_that(holds, seconds):
    end = time.monotonic() + seconds
    while not holds() and time.monotonic() < end:
        time.sleep(0.05)
    return holds()


def stick(drone, move, centre, seconds):
    """Moves a stick, lets it go, and waits until the drone has stopped."""
    move()
    time.sleep(seconds)
    centre()
    time.sleep(2)


def main():
    drone = tellopy.Tello()
    if len(sys.argv) > 2:
        drone.tello_addr = (sys.argv[1], int(sys.argv[2]))
    drone.set_loglevel(drone.LOG_ERROR)
    latest = Latest(drone)
    drone.connect()
    drone.wait_for_connection(10)
    steps.report("connect", latest.flight is not None or await_that(lambda: latest.flight, 2) is not None, want=True)

    seen = []
    started = time.monotonic()
    threading.Thread(target=watch, args=(drone, seen), daemon=True).start()
    drone.start_video()
    await_that(lambda: len(seen) >= PICTURES, PICTURES_WITHIN_S)
    within = time.monotonic() - started
    steps.report(f"{PICTURES} pictures", len(seen), near=(PICTURES, 40))
    steps.report("size of pictures", seen[0] if seen else None, want=(960, 720))
    print(f"{len(seen)} pictures in {within:.1f} s", flush=True)

    flights = latest.flights
    time.sleep(2)
    steps.report("flight data a second", (latest.flights - flights) / 2, near=(10, 0.6))

    drone.takeoff()
    steps.report("takeoff", await_that(lambda: latest.flight.fly_mode == 6, 10), want=True, free=("up", 10, 150))
    time.sleep(1)
    stick(drone, lambda: drone.up(50), lambda: drone.up(0), 1)
    steps.report("up 50", "", want="", free=("up", 10, 300))
    stick(drone, lambda: drone.forward(60), lambda: drone.forward(0), 1)
    pose = steps.report("forward 60", "", want="", free=("forward", 10, 300))
    time.sleep(0.5)
    steps.report("height", latest.flight.height, near=(pose.z / 10, 1))
    steps.report("mvo.pos_z", -latest.log.mvo.pos_z, near=(pose.z / 100, 0.3))
    drone.flip_forward()
    time.sleep(4)
    steps.report("flip_forward", "", want="", free=("forward", -100, 200))
    drone.land()
    steps.report("land", await_that(lambda: latest.flight.fly_mode == 1, 15), want=True, free=("down", 0, 400))
    drone.quit()
    print("done", flush=True)
    sys.stdout.flush()
    import os

    os._exit(0)  # its threads wait for packets


main()
