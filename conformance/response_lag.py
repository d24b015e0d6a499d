#!/usr/bin/env python3
"""Measures with TelloPy how long the drone's response takes after a stick packet, as TelloPy's author did
with a real drone, and fails if it is more than 15 % off. Takes two minutes. Run it with:

java -jar target/tello-simulator.jar run --headless --behaviour measured --room 2000x2000x400 -- \\
    conformance/.venv/bin/python conformance/response_lag.py
"""

import math
import os
import statistics
import sys
import time

import tellopy

TOLERANCE = 0.15

# Times from the packet to half of the response [s], from several flights. Measured: TelloPy 0.7.0,
# docs/sensor_time.md, section 6.
PUBLISHED = {
    "yaw rate by gyroscope": (0.091, 0.108),
    "yaw rate by IMU": (0.127, 0.135),
    "roll angle": (0.249, 0.266),
    "pitch angle": (0.260, 0.263),
}

PULSES = [  # stick, how far, for how long [s]
    *[("counter_clockwise", 50, 1.5), ("clockwise", 50, 1.5)] * 5,
    *[("right", 50, 0.6), ("left", 50, 0.6)] * 5,
    *[("forward", 50, 0.6), ("backward", 50, 0.6)] * 5,
]
REST_S = 2.5


def watch(drone):
    """Returns lists to which the times of each pulse will be added [s]."""
    sticks = tellopy.StickContainer(drone)
    imu = tellopy.ImuContainer(drone)
    gyro = tellopy.GyroContainer(drone)
    clock = tellopy.TickClock(imu)
    sources = [(gyro, "yaw"), (imu, "yaw"), (imu, "roll"), (imu, "pitch")]
    lags = {name: [] for name in PUBLISHED}
    for name, (source, axis) in zip(PUBLISHED, sources):
        estimator = tellopy.ResponseLagEstimator(sticks, source, clock, axis=axis)
        estimator.subscribe(lambda lag, seen=lags[name]: seen.append(lag.midpoint))
    return lags


def main():
    drone = tellopy.Tello()
    drone.set_loglevel(drone.LOG_ERROR)
    lags = watch(drone)
    drone.connect()
    drone.wait_for_connection(10)
    time.sleep(6)  # until the clock has enough records
    drone.takeoff()
    time.sleep(7)
    for stick, part, seconds in PULSES:
        getattr(drone, stick)(part)
        time.sleep(seconds)
        getattr(drone, stick)(0)
        time.sleep(REST_S)
    drone.land()
    time.sleep(4)
    failed = False
    print("| response | published [ms] | measured [ms] | pulses | off |")
    print("|---|---|---|---|---|")
    for name, (least, most) in PUBLISHED.items():
        median = statistics.median(lags[name] or [math.nan])
        off = median / ((least + most) / 2) - 1
        failed |= not abs(off) <= TOLERANCE
        span = f"{1000 * least:.0f} to {1000 * most:.0f}"
        print(f"| {name} | {span} | {1000 * median:.0f} | {len(lags[name])} | {off:+.0%} |")
    sys.stdout.flush()
    os._exit(int(failed))  # its threads wait for packets


main()
