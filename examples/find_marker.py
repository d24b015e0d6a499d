"""Looks for a marker with djitellopy and OpenCV, turns towards it, and lands.

Start the simulator first, in another terminal, with the marker on a wall:

    mvn javafx:run "-Djavafx.args=--on --poster right,-60,100,40,examples/marker.png"

Then start this, with the drone's host and command port if they are others:

    pip install djitellopy opencv-python
    python examples/find_marker.py [HOST PORT]

The marker is number 17 of OpenCV's ArUco markers of four by four modules (DICT_4X4_50), with a
white margin, without which it is not found. A real Tello has host 192.168.10.1 and port 8889; print
the marker for it.
"""

import math
import sys
import time

import cv2
from djitellopy import Tello

MARKER = 17
DETECTOR = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50))

FOCAL_LENGTH = 922  # in pixels: 480 / tan(55 degrees / 2)
NEAR_ENOUGH = 1  # degrees
SEARCH_STEP = 30  # degrees; the camera sees 55 from left to right
MOST_TURNS = 20
LATE_PICTURES = 10  # so many are on their way when a turn ends
LOOKS = 5  # pictures to look at; in one that is damaged the marker may be missed
PATIENCE = 10  # seconds until the next picture


def next_picture(video, last):
    """The first picture after another one."""
    patience = time.monotonic() + PATIENCE
    while True:
        picture = video.frame
        if picture is not last:
            return picture
        if time.monotonic() > patience:
            raise RuntimeError("no pictures come")
        time.sleep(0.01)


def angle_to_marker(picture):
    """How far to the right the marker is, in degrees; None if it is not to be seen."""
    corners, numbers, _ = DETECTOR.detectMarkers(cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY))
    for number, square in zip([] if numbers is None else numbers.ravel(), corners):
        if number == MARKER:
            across = square[0].mean(axis=0)[0] - picture.shape[1] / 2
            return math.degrees(math.atan(across / FOCAL_LENGTH))
    return None


def look(video):
    """How far to the right the marker is now, in degrees; None if it is in no picture."""
    picture = video.frame
    for _ in range(LATE_PICTURES):
        picture = next_picture(video, picture)
    for _ in range(LOOKS):
        angle = angle_to_marker(picture)
        if angle is not None:
            return angle
        picture = next_picture(video, picture)
    return None


def turn(tello, degrees):
    """Clockwise; counter-clockwise if negative."""
    if degrees > 0:
        tello.rotate_clockwise(degrees)
    else:
        tello.rotate_counter_clockwise(-degrees)


def face_marker(tello, video):
    """Whether the drone looks at the marker in the end."""
    for _ in range(MOST_TURNS):
        angle = look(video)
        if angle is None:
            print("No marker here.")
            turn(tello, SEARCH_STEP)
        elif abs(angle) > NEAR_ENOUGH:
            print(f"The marker is {abs(angle):.0f} degrees to the {'right' if angle > 0 else 'left'}.")
            turn(tello, round(angle))
        else:
            print("The drone looks at the marker.")
            return True
    print("There is no marker.")
    return False


host, port = sys.argv[1:3] if len(sys.argv) > 2 else ("127.0.0.1", 8879)
tello = Tello(host)
tello.address = (host, int(port))
tello.connect()
tello.streamon()
video = tello.get_frame_read()

tello.takeoff()
try:
    tello.move_up(70)
    face_marker(tello, video)
finally:
    tello.land()
    tello.streamoff()
print("Landed.")
