"""What a film flight looks at: a marker on the wall, and where the drone's camera must see it."""

import dataclasses
import math

import cv2
import numpy

WIDTH, HEIGHT = 960, 720
FIELD_OF_VIEW_DEGREES = 55
TILT_DEGREES = 15
LENS_AHEAD_CM, LENS_UP_CM = 3.5, 1.85

MARKERS = cv2.aruco.getPredefinedDictionary(cv2.aruco.DICT_4X4_50)
DETECTOR = cv2.aruco.ArucoDetector(MARKERS)
FOCAL_PIXELS = WIDTH / 2 / math.tan(math.radians(FIELD_OF_VIEW_DEGREES / 2))


@dataclasses.dataclass(frozen=True)
class Marker:
    """A marker as it was read: its number, and its corners clockwise from the upper left [pixels]."""

    number: int
    corners: numpy.ndarray

    @property
    def middle(self):
        """Where the diagonals cross, which perspective does not move."""
        a, b, c, d = (numpy.append(corner, 1) for corner in self.corners)
        crossing = numpy.cross(numpy.cross(a, c), numpy.cross(b, d))
        return crossing[:2] / crossing[2]

    @property
    def lean(self):
        """How far its upper edge is turned in the picture, in degrees clockwise."""
        across, down = self.corners[1] - self.corners[0]
        return math.degrees(math.atan2(down, across))


def read_markers(picture):
    """What can be read in a picture of red, green and blue."""
    corners, numbers, _ = DETECTOR.detectMarkers(cv2.cvtColor(picture, cv2.COLOR_RGB2GRAY))
    if numbers is None:
        return []
    return [Marker(int(n), c[0]) for n, c in zip(numbers.ravel(), corners)]


def seen_at(pose, point):
    """The pixel at which a hovering drone sees a point: across and down, the first pixel being 0.

    The point is (x, y, z) in cm in the room, as the pose is.
    """
    heading = -math.radians(pose.yaw)
    x, y = point[0] - pose.x, point[1] - pose.y
    ahead = x * math.cos(heading) + y * math.sin(heading) - LENS_AHEAD_CM
    left = -x * math.sin(heading) + y * math.cos(heading)
    up = point[2] - pose.z - LENS_UP_CM
    tilt = math.radians(TILT_DEGREES)
    depth = ahead * math.cos(tilt) - up * math.sin(tilt)
    rise = ahead * math.sin(tilt) + up * math.cos(tilt)
    across = WIDTH / 2 - FOCAL_PIXELS * left / depth
    down = HEIGHT / 2 - FOCAL_PIXELS * rise / depth
    return across - 0.5, down - 0.5
