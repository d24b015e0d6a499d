"""Flies examples/swarm_formation.py as its readers do: three drones, each at its own address."""

import pathlib
import re
import subprocess
import sys

import network
from steps import Steps

EXAMPLE = pathlib.Path(__file__).resolve().parent.parent / "examples" / "swarm_formation.py"

# The first drone goes 40 cm ahead, and each is 20 cm higher than its neighbour. See the example.
AHEAD = ("forward", 38, 42)
HEIGHTS = [60, 80, 100]

steps = Steps()
flown = subprocess.run(
    [sys.executable, str(EXAMPLE), *network.DRONES], capture_output=True, text=True
)
print(flown.stdout, flown.stderr, flush=True)
steps.report("exit code", flown.returncode, want=0, free=AHEAD)
lines = flown.stdout.splitlines()
steps.report("last line", lines[-1], want="All have landed.")
heights = re.findall(r"\d+", lines[-2])
for number, (height, wanted) in enumerate(zip(heights, HEIGHTS, strict=True), 1):
    steps.report(f"height of drone {number}", height, near=(wanted, 2))
print("done", flush=True)
