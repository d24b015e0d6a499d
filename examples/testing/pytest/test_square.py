"""Tests of a program that flies a square, and of what the simulator can break: pip install
tello-simulator pytest, and then: pytest"""

import math
import socket

import pytest
from tello_simulator import SimulatorError


class Tello:
    """The program's own drone: plain sockets, as in each tutorial."""

    def __init__(self, host, port, timeout=10):
        self.address = (host, port)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.settimeout(timeout)

    def tell(self, command):
        self.socket.sendto(command.encode(), self.address)

    def send(self, command):
        self.tell(command)
        return self.socket.recv(1024).decode().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()


def fly_square(tello, side):
    for command in ["command", "takeoff"] + [f"forward {side}", "cw 90"] * 4 + ["land"]:
        if tello.send(command) != "ok":
            return


def test_the_square_ends_where_it_began(drone):
    with Tello(drone.host, drone.command_port) as tello:
        fly_square(tello, 100)

    truth = drone.truth()
    assert truth.landed and not truth.touched
    assert math.dist(truth.position, truth.start) < 5
    assert truth.farthest == pytest.approx(math.hypot(100, 100), abs=5)
    assert drone.commands().count("cw 90") == 4


def test_nothing_of_a_test_reaches_the_next_one(drone):
    assert drone.journal() == []
    assert drone.truth().takeoffs == 0


def test_the_square_ends_at_the_first_refusal(simulator, drone):
    simulator.inject("no-valid-imu")

    with Tello(drone.host, drone.command_port) as tello:
        fly_square(tello, 100)

    assert drone.commands() == ["command", "takeoff", "forward 100"]
    assert drone.journal()[-1].reply == "error No valid imu"
    assert drone.truth().flying


def test_a_drone_whose_reply_is_lost_flies_nevertheless(simulator, drone):
    simulator.inject('loss replies 100% after "takeoff" for 5s')

    with Tello(drone.host, drone.command_port) as tello:
        tello.send("command")
        tello.tell("takeoff")
        simulator.await_still()
        tello.socket.setblocking(False)
        with pytest.raises(BlockingIOError):
            tello.socket.recv(1024)

    assert drone.truth().flying


def test_a_drone_that_hears_nothing_lands(simulator, drone):
    with Tello(drone.host, drone.command_port) as tello:
        tello.send("command")
        tello.send("takeoff")

    simulator.advance(20)

    assert drone.truth().landed


def test_a_misspelled_fault_is_refused_with_a_suggestion(simulator):
    with pytest.raises(SimulatorError, match="did you mean no-valid-imu"):
        simulator.inject("no-vaild-imu")
