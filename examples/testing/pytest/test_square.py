"""Tests of a program that flies a square, and of one that does not trust its link."""

import math
import socket

import pytest


class Tello:
    """The program's own drone: plain sockets, as in each tutorial."""

    def __init__(self, host, port, timeout=10):
        self.address = (host, port)
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.settimeout(timeout)

    def send(self, command):
        self.socket.sendto(command.encode(), self.address)
        return self.socket.recv(1024).decode().strip()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.socket.close()


def fly_square(tello, side):
    for command in ["command", "takeoff"] + [f"forward {side}", "cw 90"] * 4 + ["land"]:
        if tello.send(command) != "ok":
            return


def test_the_square_ends_where_it_began(simulator):
    with Tello(simulator.host, simulator.command_port) as tello:
        fly_square(tello, 100)

    truth = simulator.truth()
    assert truth["landed"] and not truth["touched"]
    assert math.dist((truth["x"], truth["y"]), truth["start"][:2]) < 5
    assert truth["farthest"] == pytest.approx(math.hypot(100, 100), abs=5)
    assert simulator.commands().count("cw 90") == 4


def test_nothing_of_a_test_reaches_the_next_one(simulator):
    assert simulator.journal() == []
    assert simulator.truth()["takeoffs"] == 0


def test_a_refused_square_is_not_flown_on(simulator):
    simulator.inject("no-valid-imu")

    with Tello(simulator.host, simulator.command_port) as tello:
        fly_square(tello, 100)

    assert simulator.commands() == ["command", "takeoff", "forward 100"]
    assert simulator.journal()[-1]["reply"] == "error No valid imu"
    assert simulator.truth()["flying"]


def test_a_lost_reply_does_not_take_off_twice(simulator):
    simulator.inject('loss replies 100% after "takeoff" for 3.1s')

    with Tello(simulator.host, simulator.command_port, timeout=0.3) as tello:
        tello.send("command")
        with pytest.raises(socket.timeout):
            tello.send("takeoff")

    assert simulator.truth()["flying"]
    assert simulator.commands().count("takeoff") == 1


def test_a_drone_that_hears_nothing_lands(simulator):
    with Tello(simulator.host, simulator.command_port) as tello:
        tello.send("command")
        tello.send("takeoff")

    simulator.advance(20)

    assert simulator.truth()["landed"]


def test_a_request_that_makes_no_sense_is_told(simulator):
    with pytest.raises(AssertionError, match="did you mean no-valid-imu"):
        simulator.inject("no-vaild-imu")
