"""What each step should have been answered, and where it should have led."""

import re

TOLERANCE_CM = 2.0
TOLERANCE_DEGREES = 1.0

TAKEOFF_HEIGHT_CM = 30
LOWEST_HOVER_CM = 10
FLIP_LEAST_CM, FLIP_MOST_CM = 20, 40

DIRECTIONS = {
    "forward": (1, 0, 0),
    "back": (-1, 0, 0),
    "left": (0, 1, 0),
    "right": (0, -1, 0),
    "up": (0, 0, 1),
    "down": (0, 0, -1),
}
FLIPS = {"f": "forward", "b": "back", "l": "left", "r": "right"}


class Judge:
    """Reckons the drone's pose from the commands alone, and compares it with the core's own.

    Only after what cannot be reckoned to the centimetre (sticks, flips, a move cut short) and after
    a step that went wrong does it take over where the drone is.
    """

    def __init__(self, simulator):
        self._simulator = simulator
        self.reckoned = simulator.pose()
        self.steps = 0
        self.worst_cm = 0.0

    def judge(self, step):
        """The drone's pose after a step, and what is wrong with the step: nothing, if all is well."""
        self.steps += 1
        faults = []
        if not _as_expected(step):
            faults.append("expected " + _expectation(step))
        free = step.get("free") or _flip(step)
        if free:
            pose, fault = self._follow(step, free)
        else:
            pose, fault = self._compare(step)
        return pose, faults + fault

    def _compare(self, step):
        words = step["command"].split()
        if step["reply"] == "ok":
            self.reckoned = _led_to(self.reckoned, words)
        if words[0] == "emergency":
            self.reckoned = self.reckoned.at_height(0)
            pose = self._simulator.pose_at_rest()
        else:
            pose = self._simulator.pose()
        off = pose.distance(self.reckoned)
        self.worst_cm = max(self.worst_cm, off)
        if off > TOLERANCE_CM or pose.yaw_off(self.reckoned) > TOLERANCE_DEGREES:
            expected, self.reckoned = self.reckoned, pose
            return pose, [f"expected it at {expected}"]
        return pose, []

    def _follow(self, step, free):
        start = self.reckoned
        self.reckoned = pose = self._simulator.pose_at_rest()
        if step.get("lands"):
            start = start.at_height(0)
        way = pose.seen_from(start)
        unit = DIRECTIONS[free["direction"]]
        along = sum(a * b for a, b in zip(way, unit))
        aside = max(abs(a - along * b) for a, b in zip(way, unit))
        if free["least"] <= along <= free["most"] and aside <= free.get("aside", TOLERANCE_CM):
            return pose, []
        wanted = "{least} to {most} cm {direction}".format(**free)
        return pose, [f"expected it {wanted}, not {along:.1f} cm and {aside:.1f} cm aside"]


def _as_expected(step):
    if "near" in step:
        value, tolerance = step["near"]
        return abs(float(step["reply"]) - value) <= tolerance
    if "least" in step:
        return float(step["reply"]) >= step["least"]
    if "pattern" in step:
        return re.fullmatch(step["pattern"], step["reply"], re.DOTALL) is not None
    return step["reply"] == step["want"]


def _expectation(step):
    if "near" in step:
        return "{} ± {}".format(*step["near"])
    if "least" in step:
        return "at least {}".format(step["least"])
    return repr(step.get("pattern", step.get("want")))


def _flip(step):
    words = step["command"].split()
    if words[0] != "flip" or step["reply"] != "ok":
        return None
    return {"direction": FLIPS[words[1]], "least": FLIP_LEAST_CM, "most": FLIP_MOST_CM}


def _led_to(pose, words):
    verb, numbers = words[0], words[1:]
    if verb == "takeoff":
        return pose.at_height(pose.z + TAKEOFF_HEIGHT_CM)
    if verb == "land":
        return pose.at_height(0)
    if verb in DIRECTIONS:
        distance = float(numbers[0])
        goal = pose.moved(*(distance * part for part in DIRECTIONS[verb]))
        return goal.at_height(max(goal.z, LOWEST_HOVER_CM)) if verb == "down" else goal
    if verb in ("cw", "ccw"):
        return pose.turned(float(numbers[0]) * (1 if verb == "cw" else -1))
    if verb == "go":
        return pose.moved(*map(float, numbers[:3]))
    if verb == "curve":
        return pose.moved(*map(float, numbers[3:6]))
    return pose
