"""Simulated Tello drones for pytest. Copy this file beside your tests; it needs nothing but pytest
and Java, and the simulator's jar where TELLO_SIMULATOR_JAR says.

A test with the parameter `simulator` gets a simulator that has just been reset:

    def test_it_lands(simulator):
        fly(simulator.host, simulator.command_port)   # your program
        assert simulator.truth()["landed"]
"""

import json
import os
import socket
import subprocess

import pytest

JAR = os.environ.get("TELLO_SIMULATOR_JAR", "tello-simulator.jar")
JAVA = os.environ.get("TELLO_SIMULATOR_JAVA", "java")
LONGEST_ANSWER = 600  # seconds


def free_port():
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]


class Simulator:
    """The simulator's process and its control channel. Lengths are centimetres, angles degrees
    clockwise, times seconds of the simulation."""

    def __init__(self, *options):
        command = [JAVA, "-jar", JAR, "--headless", "--command-port", "0", "--time-factor", "max"]
        command += ["--state-port", str(free_port()), "--video-port", str(free_port())]
        command += ["--control", "0", "--log-level", "off", *options]
        self.process = subprocess.Popen(
            command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        where = token = ""
        for line in self.process.stdout:
            if line.startswith("control: "):
                _, where, _, token = line.split()
            if line.startswith("ready"):
                break
        else:
            raise RuntimeError(f"the simulator ended with {self.process.wait()}: {command}")
        host, port = where.split(":")
        self.token = token
        self.socket = socket.create_connection((host, int(port)), LONGEST_ANSWER)
        self.answers = self.socket.makefile("r")
        first = self.drones()[0]
        self.host, self.command_port = first["host"], first["commandPort"]
        self.state_port, self.video_port = first["statePort"], first["videoPort"]

    def ask(self, what, **parameters):
        """Carries out a request; docs/testing.md lists them all."""
        request = {"token": self.token, "do": what, **parameters}
        self.socket.sendall(json.dumps(request).encode() + b"\n")
        answer = json.loads(self.answers.readline())
        assert answer["ok"], answer["error"]
        return answer["result"]

    def drones(self):
        return self.ask("drones")

    def truth(self, drone=1):
        """The true state of a drone, and what it did, independent of the wire."""
        return self.ask("truth", drone=drone)

    def journal(self, drone=1):
        """All texts that came to a drone, with their replies."""
        return self.ask("journal", drone=drone)

    def commands(self, drone=1):
        return [entry["text"] for entry in self.journal(drone)]

    def inject(self, fault):
        """Lets something go wrong, such as "loss replies 20% for 10s"."""
        self.ask("inject", fault=fault)

    def advance(self, seconds):
        """Lets simulated time pass while your program waits for no reply."""
        self.ask("advance", seconds=seconds)

    def await_still(self):
        """Waits until all commands are carried out and nothing moves but what hovers."""
        self.ask("await-still")

    def reset(self):
        """Starts again: same places, full batteries, no faults, empty journals."""
        self.ask("reset")

    def close(self):
        self.socket.close()
        self.process.terminate()
        self.process.communicate()


@pytest.fixture(scope="session")
def running_simulator():
    simulator = Simulator()
    yield simulator
    simulator.close()


@pytest.fixture
def simulator(running_simulator):
    running_simulator.reset()
    return running_simulator


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(item, call):
    """Adds to a failure what the drones did."""
    report = yield
    if report.when == "call" and report.failed and "simulator" in item.funcargs:
        report.sections.append(("drones", item.funcargs["simulator"].ask("explanation")))
    return report
