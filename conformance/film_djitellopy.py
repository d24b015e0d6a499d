"""Films with djitellopy: what its `get_frame_read` shows while the drone flies.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import logging
import math
import sys
import time

import av
import av.logging
import cv2
from djitellopy import Tello

import pace
import sight
from steps import Steps
from watcher import Watcher

# In cm in the room; x is that of the default room's front wall, y is to the left. See run.py.
NUMBER = 17  # examples/marker.png
MARKER_AT = (250, -20, 80)
RED_AT = (250, 40, 80)

PIXELS_OFF = 2
LEAST_LEAN = 2
LEAST_PICTURES_IN_5_S = 75  # 150 on a machine that has nothing else to do
LONGEST_OPENING_S = 5

steps = Steps()


def connected(arguments):
    if not arguments:
        return Tello()
    drone = Tello(arguments[0])
    drone.address = (arguments[0], int(arguments[1]))
    return drone


def fly(command, call, *arguments):
    call(*arguments)  # raises what is not `ok`
    return steps.report(command, "ok", want="ok")


def markers(picture):
    return [marker for marker in sight.read_markers(picture) if marker.number == NUMBER]


def off(picture, pose):
    """How far the marker is from where geometry says it must be [pixels]."""
    wanted = sight.seen_at(pose, MARKER_AT)
    return min((math.dist(m.middle, wanted) for m in markers(picture)), default=math.inf)


def in_place(pose):
    return lambda picture: off(picture, pose) <= PIXELS_OFF


def marker_in(picture, pose):
    """Reads the marker, which must be where geometry says; returns where it is."""
    found = markers(picture)
    distance = math.dist((pose.x, pose.y, pose.z), MARKER_AT)
    steps.report(f"markers at {distance:.0f} cm", [marker.number for marker in found], [NUMBER])
    seen = found[0].middle if found else (math.nan, math.nan)
    wanted = sight.seen_at(pose, MARKER_AT)
    for axis, is_at, must_be in zip(("across", "down"), seen, wanted):
        steps.report(f"marker {axis} [pixels]", f"{is_at:.1f}", near=(must_be, PIXELS_OFF))
    return seen


def first_picture(drone, asked):
    watcher = Watcher(drone.get_frame_read())
    opened = time.monotonic() - asked
    picture = watcher.first()
    seconds = time.monotonic() - asked
    steps.report("get_frame_read() [s]", f"{opened:.2f}", near=(0, LONGEST_OPENING_S))
    steps.report("first picture [s]", f"{seconds:.2f}", near=(0, LONGEST_OPENING_S + 1))
    steps.report("its shape", picture.shape, (sight.HEIGHT, sight.WIDTH, 3))
    return watcher


def colours(picture, pose):
    across, down = (round(pixel) for pixel in sight.seen_at(pose, RED_AT))
    spot = picture[down - 5 : down + 6, across - 5 : across + 6].reshape(-1, 3).mean(axis=0)
    steps.report("red beside red, green, blue", spot[0] - spot[1:].max(), least=60)


def lean(drone, watcher):
    """To the right and back: the drone leans to the right, and then to the left to brake.

    While it leans to the right, what it sees leans to the left.
    """
    with watcher.keeping() as pictures:
        watcher.until(in_place(fly("right 40", drone.move_right, 40)))
    leans = [marker.lean for picture in pictures for marker in markers(picture)]
    steps.report("leans to the left [degrees]", f"{-min(leans, default=0):.1f}", least=LEAST_LEAN)
    steps.report("leans to the right [degrees]", f"{max(leans, default=0):.1f}", least=LEAST_LEAN)
    fly("left 40", drone.move_left, 40)


def turn(drone, watcher, before):
    """To the right, which moves the marker to the left."""
    pose = fly("cw 10", drone.rotate_clockwise, 10)
    after = marker_in(watcher.until(in_place(pose)), pose)
    steps.report("turn moved it left [pixels]", f"{before[0] - after[0]:.1f}", least=100)
    return pose


def opencv(pose):
    """OpenCV's own reader sees the same."""
    video = cv2.VideoCapture(f"udp://@0.0.0.0:{pace.VIDEO_PORT}", cv2.CAP_FFMPEG)
    there, picture = video.read()
    steps.report("OpenCV reads a picture", there, True)
    if there:
        marker_in(cv2.cvtColor(picture, cv2.COLOR_BGR2RGB), pose)
    video.release()


def main():
    av.logging.set_level(av.logging.WARNING)
    drone = connected(sys.argv[1:])
    drone.LOGGER.setLevel(logging.WARNING)
    pace.await_full_pace(*drone.address)
    fly("command", drone.connect)
    asked = time.monotonic()
    fly("streamon", drone.streamon)
    watcher = first_picture(drone, asked)
    with av.logging.Capture(local=False) as warnings:
        fly("takeoff", drone.takeoff)
        pose = fly("up 70", drone.move_up, 70)
        picture = watcher.until(in_place(pose))
        colours(picture, pose)
        before = marker_in(picture, pose)
        lean(drone, watcher)
        pose = turn(drone, watcher, before)
    steps.report("warnings of the decoder", warnings, [])
    steps.report("pictures in 5 s", watcher.most_within(5), least=LEAST_PICTURES_IN_5_S)
    watcher.stop()
    opencv(pose)
    fly("land", drone.land)
    fly("streamoff", drone.streamoff)
    print("done", flush=True)


main()
