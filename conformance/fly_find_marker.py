"""Flies examples/find_marker.py as its readers do: in the end the drone looks at the marker.

HOST and PORT as arguments are the drone's.
"""

import math
import pathlib
import subprocess
import sys

import pace
from steps import Steps

EXAMPLE = pathlib.Path(__file__).resolve().parent.parent / "examples" / "find_marker.py"

# In cm to the right and ahead of the drone, in the default room. See run.py.
MARKER_AT = (250, 60)

DEGREES_OFF = 2
END = ["The drone looks at the marker.", "Landed."]

steps = Steps()
pace.await_full_pace(sys.argv[1], int(sys.argv[2]))
flown = subprocess.run(
    [sys.executable, str(EXAMPLE), *sys.argv[1:]], capture_output=True, text=True
)
print(flown.stdout, flown.stderr, flush=True)
steps.report("exit code", flown.returncode, want=0, free=("up", -2, 2))
pose = steps.report("last lines", flown.stdout.splitlines()[-2:], want=END)
steps.report("yaw", pose.yaw, near=(math.degrees(math.atan2(*MARKER_AT)), DEGREES_OFF))
print("done", flush=True)
