"""The simulator as a process, and what its console says about the drone."""

import contextlib
import dataclasses
import math
import re
import subprocess
import tempfile
import time

STATE = re.compile(
    r"drone 1: .+?, x (?P<x>\S+) y (?P<y>\S+) z (?P<z>\S+) cm, yaw (?P<yaw>\S+) degrees,"
    r" battery (?P<battery>\d+) %.*?, (?P<time>[\d.]+) s"
)
LEAST_TIME_AT_REST_S = 0.1  # simulated; a drone of a busy machine stays where it is, too


@dataclasses.dataclass(frozen=True)
class Pose:
    """Where the drone is: cm in the room, x along the nose at the start, y to its left, z up; yaw in
    degrees clockwise. And what is left of its battery, in per cent, and the simulated time in s."""

    x: float
    y: float
    z: float
    yaw: float
    battery: int
    time: float

    def moved(self, forward=0.0, left=0.0, up=0.0):
        heading = -math.radians(self.yaw)
        return dataclasses.replace(
            self,
            x=self.x + forward * math.cos(heading) - left * math.sin(heading),
            y=self.y + forward * math.sin(heading) + left * math.cos(heading),
            z=self.z + up,
        )

    def turned(self, clockwise):
        return dataclasses.replace(self, yaw=self.yaw + clockwise)

    def at_height(self, z):
        return dataclasses.replace(self, z=z)

    def seen_from(self, other):
        """This position as forward, left, up of another pose."""
        heading = -math.radians(other.yaw)
        x, y = self.x - other.x, self.y - other.y
        forward = x * math.cos(heading) + y * math.sin(heading)
        left = -x * math.sin(heading) + y * math.cos(heading)
        return forward, left, self.z - other.z

    def distance(self, other):
        return math.dist((self.x, self.y, self.z), (other.x, other.y, other.z))

    def yaw_off(self, other):
        return abs(math.remainder(self.yaw - other.yaw, 360))

    def __str__(self):
        yaw = math.remainder(self.yaw, 360)
        x, y, z, yaw = (round(value, 1) + 0.0 for value in (self.x, self.y, self.z, yaw))
        return f"x {x:6.1f}  y {y:6.1f}  z {z:5.1f}  yaw {yaw:6.1f}"


class Simulator:
    """Runs from `with` to the end of its block."""

    def __init__(self, java, jar, options):
        self._command = [java, "-jar", jar, "--headless", *options]
        self._waits = "max" in options  # then no time passes until the next command
        self._log = tempfile.TemporaryFile(mode="w+")
        self._process = None
        self.ready = ""  # the line that says where its drones listen

    def __enter__(self):
        self._process = subprocess.Popen(
            self._command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._log,
            text=True,
            bufsize=1,
        )
        self.ready = self._line_with("ready")
        return self

    def __exit__(self, *failure):
        try:
            self._process.communicate("quit\n", timeout=5)
        except (subprocess.TimeoutExpired, BrokenPipeError):
            self._process.kill()
            self._process.wait()
        self._log.close()

    def _line_with(self, start):
        for line in self._process.stdout:
            if line.startswith(start):
                return line
        raise RuntimeError("the simulator ended:\n" + self.log())

    def kill(self):
        self._process.kill()

    def pose(self):
        with contextlib.suppress(BrokenPipeError):
            self._process.stdin.write("state\n")
        found = STATE.match(self._line_with("drone 1:"))
        x, y, z, yaw, time = (float(found[name]) for name in ("x", "y", "z", "yaw", "time"))
        return Pose(x, y, z, yaw, int(found["battery"]), time)

    def pose_at_rest(self, patience=3.0):
        """The pose, as soon as it stays the same."""
        end = time.monotonic() + patience
        last = self.pose()
        while time.monotonic() < end:
            time.sleep(0.1)
            pose = self.pose()
            if pose.distance(last) >= 0.1 or pose.yaw_off(last) >= 0.1:
                last = pose
            elif self._waits or pose.time - last.time >= LEAST_TIME_AT_REST_S:
                return pose
        return last

    def log(self):
        self._log.seek(0)
        return self._log.read()


class Proxy:
    """Stands between a client and the simulator from `with` to the end of its block."""

    def __init__(self, java, jar, options):
        self._recordings = tempfile.TemporaryDirectory()
        self._command = [
            *(java, "-jar", jar, "proxy", "--command-port", "8889"),
            *("--record", self._recordings.name, *options),
        ]
        self._process = None

    def __enter__(self):
        self._process = subprocess.Popen(
            self._command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True, bufsize=1
        )
        if not self._process.stdout.readline().startswith("ready"):
            raise RuntimeError("the proxy did not start")
        return self

    def __exit__(self, *failure):
        try:
            self._process.communicate("quit\n", timeout=10)
        except (subprocess.TimeoutExpired, BrokenPipeError):
            self._process.kill()
            self._process.wait()
        self._recordings.cleanup()
