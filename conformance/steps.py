"""What a Python client tells the runner: a line for each command, answered with the drone's pose."""

import json
import sys


class Pose:
    """What the drone's core says: cm in the room, yaw in degrees clockwise, battery in per cent."""

    def __init__(self, answer):
        self.x, self.y, self.z = answer["x"], answer["y"], answer["z"]
        self.yaw, self.battery = answer["yaw"], answer["battery"]


class Steps:
    """Reports each command to the runner, which judges the reply and where the drone is.

    Every expectation is one of `want` (exactly this text), `pattern` (a regular expression for all
    of it), `near` (a number and how far off it may be) and `least` (a number that it must reach).
    `free` = (direction, least, most) says how far the command leads when that cannot be known to
    the centimetre.
    """

    def report(self, command, reply, want=None, pattern=None, near=None, least=None, free=None):
        step = {"command": command, "reply": str(reply)}
        if free is not None:
            step["free"] = dict(zip(("direction", "least", "most"), free))
        if pattern is not None:
            step["pattern"] = pattern
        elif near is not None:
            step["near"] = near
        elif least is not None:
            step["least"] = least
        else:
            step["want"] = str(want)
        print("step " + json.dumps(step), flush=True)
        answer = sys.stdin.readline()
        if not answer:
            raise SystemExit("the runner is gone")
        return Pose(json.loads(answer))
