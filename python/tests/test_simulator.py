"""Tests of the package against a real simulator."""

from __future__ import annotations

import socket
import sys
import types
import urllib.request
from collections.abc import Iterable, Iterator
from pathlib import Path

import pytest

from tello_simulator import Drone, Simulator, SimulatorError, notebook, write_report

pytest_plugins = ["pytester"]


def fly(drone: Drone, commands: Iterable[str]) -> list[str]:
    """Send commands as any program does, and return the replies."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.settimeout(10)
        replies = []
        for command in commands:
            operator.sendto(command.encode(), drone.address)
            replies.append(operator.recv(1024).decode())
        return replies


@pytest.fixture(scope="module")
def shared() -> Iterator[Simulator]:
    with Simulator(drones=2, seed=3) as simulator:
        yield simulator


@pytest.fixture
def reset(shared: Simulator) -> Simulator:
    shared.reset()
    return shared


def test_truth_and_journal_tell_what_a_program_did(reset: Simulator) -> None:
    assert fly(reset.drone, ["command", "takeoff", "forward 100", "land"]) == ["ok"] * 4

    truth = reset.drone.truth()
    assert truth.landed and not truth.flying and not truth.crashed
    assert truth.x - truth.start[0] == pytest.approx(100, abs=2)
    assert truth.position[0] == truth.x
    assert truth.takeoffs == 1
    assert truth.touched == ()
    assert len(truth.path) > 10
    assert reset.drone.commands() == ["command", "takeoff", "forward 100", "land"]
    assert [entry.reply for entry in reset.drone.journal()] == ["ok"] * 4


def test_a_refused_command_is_explained(reset: Simulator) -> None:
    fly(reset.drone, ["command", "foward 100"])

    entry = reset.drone.journal()[-1]
    assert entry.outcome == "refused"
    assert "did you mean" in entry.explanation
    assert "did you mean" in reset.explanation()


def test_a_command_without_reply_has_none(reset: Simulator) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.sendto(b"command", reset.drone.address)
        operator.sendto(b"rc 0 0 0 0", reset.drone.address)
        entry = reset.drone.await_command("rc 0 0 0 0")

    assert entry.reply == ""
    assert entry.replies == ()


def test_packets_of_the_app_are_named_in_words(reset: Simulator) -> None:
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.settimeout(10)
        operator.sendto(b"conn_req:\x96\x17", reset.drone.address)
        assert operator.recv(1024) == b"conn_ack:\x96\x17"
        operator.sendto(bytes.fromhex("cc58007c68540001006a90"), reset.drone.address)
        takeoff = reset.drone.await_command("takeoff")

    assert (takeoff.text, takeoff.reply) == ("takeoff (app)", "ok")
    assert reset.drone.commands() == ["conn_req (app)", "takeoff (app)"]


def test_drones_are_apart(reset: Simulator) -> None:
    first, second = reset.drones

    fly(second, ["command", "takeoff"])

    assert not first.truth().flying
    assert second.truth().flying
    assert first.address != second.address


def test_battery_place_power_and_wind_are_set(reset: Simulator) -> None:
    reset.drone.battery(40)
    reset.drone.place(50, -50, heading=90)
    reset.wind(100, towards=90)
    reset.link("lab")

    truth = reset.drone.truth()
    assert truth.battery == 40
    assert (truth.x, truth.y) == pytest.approx((50, -50), abs=1)
    assert truth.heading == pytest.approx(90, abs=1)
    reset.drone.power(False)
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.settimeout(0.5)
        operator.sendto(b"command", reset.drone.address)
        with pytest.raises(OSError):
            operator.recv(10)
    reset.drone.power(True)
    with pytest.raises(SimulatorError, match="battery is 101"):
        reset.drone.battery(101)


def test_wind_carries_the_drone(reset: Simulator) -> None:
    reset.wind(600, towards=90)
    fly(reset.drone, ["command", "takeoff"])
    before = reset.drone.truth().position

    fly(reset.drone, ["land"])

    assert reset.drone.truth().position[:2] != pytest.approx(before[:2], abs=1)


def test_faults_come_and_go(reset: Simulator) -> None:
    reset.inject("no-valid-imu")
    assert any("imu" in fault for fault in reset.drone.faults())

    reset.clear_faults()

    assert reset.drone.faults() == []


def test_a_misspelled_fault_is_refused_with_a_suggestion(reset: Simulator) -> None:
    with pytest.raises(SimulatorError, match="did you mean no-valid-imu"):
        reset.inject("no-vaild-imu")


def test_time_passes_on_demand(reset: Simulator) -> None:
    fly(reset.drone, ["command", "takeoff"])
    assert reset.drone.await_command("takeoff").reply == "ok"

    reset.advance(20)

    assert reset.drone.truth().landed


def test_goals_and_score_are_typed(tmp_path: Path) -> None:
    scenario = tmp_path / "up.yaml"
    scenario.write_text(
        "goals:\n"
        "  - reach: {at: [0, 0, 130], radius: 40}\n"
        "  - land: {at: [0, 0], radius: 30}\n",
        encoding="utf-8",
    )
    with Simulator(scenario) as simulator:
        assert len(simulator.goals().open) == 2
        fly(simulator.drone, ["command", "takeoff", "up 100", "land"])

        goals = simulator.await_goals()

    assert goals.reached and not goals.failed and goals.open == ()
    assert goals.score is None


def test_a_built_in_scenario_a_link_and_faults_are_set() -> None:
    with Simulator("gate-race", seed=7, link="lab", faults=["loss state 20%"]) as simulator:
        assert simulator.goals().open
        assert simulator.drone.faults()


def test_wrong_settings_are_explained() -> None:
    with pytest.raises(SimulatorError, match="gate-race"):
        Simulator("gate-rase")


def test_a_missing_jar_is_named(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("TELLO_SIMULATOR_JAR", "/nowhere/tello.jar")
    with pytest.raises(FileNotFoundError, match="/nowhere/tello.jar; set TELLO_SIMULATOR_JAR"):
        Simulator()


def test_a_closed_simulator_says_so() -> None:
    simulator = Simulator()
    simulator.close()

    with pytest.raises(SimulatorError, match="closed"):
        simulator.goals()


@pytest.fixture
def cell(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The pages that are shown below a cell of a notebook."""
    shown: list[str] = []
    display = types.ModuleType("IPython.display")
    setattr(display, "IFrame", lambda page, width, height: page)
    setattr(display, "display", shown.append)
    monkeypatch.setitem(sys.modules, "IPython", types.ModuleType("IPython"))
    monkeypatch.setitem(sys.modules, "IPython.display", display)
    return shown


def test_a_notebook_shows_the_page_and_flies(cell: list[str]) -> None:
    with notebook("gate-race", time_factor="max") as flight:
        with urllib.request.urlopen(cell[0]) as page:
            assert "Tello Simulator" in page.read().decode()
        assert flight.send("takeoff") == "ok"
        assert flight.send("forward 9") == "out of range"
        assert flight.simulator.drone.truth().takeoffs == 1


def test_a_notebook_of_a_hub_goes_through_its_proxy(
    cell: list[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("JUPYTERHUB_SERVICE_PREFIX", "/user/ada/")
    with notebook() as flight:
        assert flight.simulator.page is not None
        port, query = flight.simulator.page.removeprefix("http://127.0.0.1:").split("/")
    assert cell == [f"/user/ada/proxy/{port}/{query}"]


def test_a_recorded_flight_has_a_report(tmp_path: Path) -> None:
    with Simulator(record=tmp_path / "flights") as simulator:
        fly(simulator.drone, ["command", "takeoff", "land"])
    (flight,) = (tmp_path / "flights").iterdir()

    write_report(flight, tmp_path / "flight.html")

    assert "takeoff" in (tmp_path / "flight.html").read_text(encoding="utf-8")
    with pytest.raises(SimulatorError):
        write_report(tmp_path / "nothing", tmp_path / "flight.html")


FLYING = """
import socket
import pytest

def send(drone, *commands):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.settimeout(10)
        for command in commands:
            operator.sendto(command.encode(), drone.address)
            operator.recv(1024)
"""


def test_the_plugin_gives_each_test_a_fresh_drone(pytester: pytest.Pytester) -> None:
    pytester.makepyfile(
        FLYING
        + """
def test_it_flies(drone):
    send(drone, "command", "takeoff")
    assert drone.truth().flying

def test_nothing_is_left_of_it(drone, simulator):
    assert drone.journal() == []
    assert simulator.drone is drone

def test_a_simulator_may_end(simulator):
    simulator.close()

def test_an_ended_simulator_breaks_no_report(simulator):
    simulator.close()
    assert False

def test_the_next_test_gets_a_new_one(drone):
    send(drone, "command")

@pytest.mark.tello("gate-race", seed=7, link="lab")
def test_a_marker_sets_the_scenario(simulator):
    assert simulator.goals().open

class TestSwarm:
    pytestmark = pytest.mark.tello(drones=2)

    def test_a_marker_of_a_class(self, simulator):
        assert len(simulator.drones) == 2
"""
    )

    result = pytester.runpytest_subprocess("--strict-markers")

    result.assert_outcomes(passed=6, failed=1)
    assert not list((pytester.path / "tello-flights").glob("*fresh*"))


def test_a_failure_explains_itself_and_has_a_report(pytester: pytest.Pytester) -> None:
    pytester.makepyfile(
        test_square=FLYING
        + """
def test_it_lands(drone):
    send(drone, "command", "takeoff", "foward 100")
    assert drone.truth().landed
"""
    )

    result = pytester.runpytest_subprocess("--junitxml=report.xml")

    result.assert_outcomes(failed=1)
    result.stdout.fnmatch_lines(["*drones*", "*`foward 100`*did you mean `forward 100`*", "report: *"])
    page = pytester.path / "tello-flights" / "test_square.py-test_it_lands.html"
    assert "foward 100" in page.read_text(encoding="utf-8")
    assert "tello-report" in (pytester.path / "report.xml").read_text(encoding="utf-8")
