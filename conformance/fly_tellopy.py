"""Flies TelloPy, which speaks the binary protocol of the drone's app.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import io
import os
import sys
import threading
import time

import av
import PIL.Image
import tellopy

from steps import Steps

PICTURES = 200
PICTURES_WITHIN_S = 12

steps = Steps()


class Latest:
    """What the drone has told last, and how often."""

    def __init__(self, drone):
        self.flight, self.log, self.photo, self.flights = None, None, None, 0
        drone.subscribe(drone.EVENT_FLIGHT_DATA, self.flown)
        drone.subscribe(drone.EVENT_FILE_RECEIVED, self.received)
        if hasattr(drone, "EVENT_LOG_DATA"):  # 0.6.0 reads no records
            drone.subscribe(drone.EVENT_LOG_DATA, self.logged)

    def flown(self, event, sender, data, **_):
        self.flight = data
        self.flights += 1

    def received(self, event, sender, data, **_):
        self.photo = bytes(data)

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


def stick(move, part):
    """Moves a stick for a second, lets it go, and waits until the drone has stopped."""
    move(part)
    time.sleep(1)
    move(0)
    time.sleep(2)


def main():
    drone = tellopy.Tello()
    if len(sys.argv) > 2:
        drone.tello_addr = (sys.argv[1], int(sys.argv[2]))
    drone.set_loglevel(drone.LOG_ERROR)
    latest = Latest(drone)
    drone.connect()
    drone.wait_for_connection(10)
    steps.report("connect", await_that(lambda: latest.flight is not None, 2), want=True)

    seen = []
    started = time.monotonic()
    threading.Thread(target=watch, args=(drone, seen), daemon=True).start()
    drone.start_video()
    await_that(lambda: len(seen) >= PICTURES, PICTURES_WITHIN_S)
    within = time.monotonic() - started
    steps.report(f"{PICTURES} pictures", len(seen), least=PICTURES)
    steps.report("size of pictures", seen[0] if seen else None, want=(960, 720))
    steps.report("seconds for them", round(within, 1), near=(6, 6))

    flights = latest.flights
    time.sleep(2)
    steps.report("flight data a second", (latest.flights - flights) / 2, near=(10, 0.6))

    drone.takeoff()
    hovers = await_that(lambda: latest.flight.fly_mode == 6, 10)
    steps.report("takeoff", hovers, want=True, free=("up", 10, 150))
    time.sleep(1)
    stick(drone.up, 50)
    steps.report("up 50", "", want="", free=("up", 10, 300))
    stick(drone.forward, 60)
    pose = steps.report("forward 60", "", want="", free=("forward", 10, 300))
    time.sleep(0.5)
    steps.report("height", latest.flight.height, near=(pose.z / 10, 1))
    if latest.log is not None:
        mvo = latest.log.mvo
        steps.report("mvo.pos_z", -mvo.pos_z, near=(pose.z / 100, 0.3))
        steps.report("mvo.pos_x", mvo.pos_x, near=(pose.x / 100, 0.3))
    stick(drone.clockwise, 50)
    turned = steps.report("clockwise 50", "", want="", free=("up", -5, 5)).yaw - pose.yaw
    steps.report("turned", turned, near=(45, 40))
    drone.flip_forward()
    time.sleep(4)
    steps.report("flip forward", "", want="", free=("forward", 20, 100))
    drone.take_picture()
    await_that(lambda: latest.photo is not None, 15)
    photo = PIL.Image.open(io.BytesIO(latest.photo))
    photo.load()
    steps.report("photo", f"{photo.format} {photo.size}", want="JPEG (2592, 1936)")
    drone.land()
    stands = await_that(lambda: latest.flight.fly_mode == 1, 15)
    steps.report("land", stands, want=True, free=("down", 0, 400))
    drone.quit()
    print("done", flush=True)
    os._exit(0)  # its threads wait for packets


main()
