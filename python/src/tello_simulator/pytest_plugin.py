"""The pytest plugin: a fresh simulator for each test that asks for one.

    def test_it_lands(drone):
        fly(drone.host, drone.command_port)  # your program
        assert drone.truth().landed

    @pytest.mark.tello("gate-race", seed=7)
    def test_it_flies_the_race(simulator): ...

If such a test fails, pytest shows what the drones did, and a report of the flight is written to the
folder tello-flights.
"""

from __future__ import annotations

import re
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any, Optional

import pytest

from ._simulator import Drone, Simulator, write_report

_REPORTS = "tello-flights"
_MARKER = "tello"
_report_file = pytest.StashKey[Path]()


def pytest_configure(config: pytest.Config) -> None:
    config.addinivalue_line(
        "markers",
        f"{_MARKER}(scenario=None, *, seed, link, drones, profile, behaviour, faults, time_factor,"
        " options): settings of the simulator that the test gets, as those of"
        " tello_simulator.Simulator",
    )


class _Garage:
    """Keeps a simulator running for the next tests with the same settings."""

    def __init__(self, recordings: Path) -> None:
        self._recordings = recordings
        self._settings: Optional[str] = None
        self._running: Optional[Simulator] = None

    def simulator(self, *settings: object, **named: Any) -> Simulator:
        key = repr((settings, sorted(named.items())))
        if self._running is None or key != self._settings:
            self.close()
            self._running = Simulator(*settings, record=self._recordings, **named)  # type: ignore[arg-type]
            self._settings = key
        self._running.reset()
        return self._running

    def flights(self) -> list[Path]:
        """Return the folders of the recorded flights, the oldest first."""
        return sorted(self._recordings.glob("*/"), key=lambda folder: folder.stat().st_mtime)

    def close(self) -> None:
        if self._running is not None:
            self._running.close()
            self._running = None


@pytest.fixture(scope="session")
def _tello_garage(tmp_path_factory: pytest.TempPathFactory) -> Iterator[_Garage]:
    garage = _Garage(tmp_path_factory.mktemp(_REPORTS))
    yield garage
    garage.close()


@pytest.fixture
def simulator(request: pytest.FixtureRequest, _tello_garage: _Garage) -> Iterator[Simulator]:
    """A simulator that has just been reset, with the settings of the marker `tello`."""
    marker = request.node.get_closest_marker(_MARKER) or pytest.mark.tello().mark
    garage = _tello_garage
    running = garage.simulator(*marker.args, **marker.kwargs)
    before = set(garage.flights())
    yield running
    page = request.node.stash.get(_report_file, None)
    if page is not None:
        running.reset()  # completes the recording
        flights = [flight for flight in garage.flights() if flight not in before]
        if flights:
            page.parent.mkdir(exist_ok=True)
            write_report(flights[-1], page)


@pytest.fixture
def drone(simulator: Simulator) -> Drone:
    """The first drone of `simulator`."""
    return simulator.drone


@pytest.hookimpl(wrapper=True)
def pytest_runtest_makereport(
    item: pytest.Item, call: pytest.CallInfo[None]
) -> Generator[None, pytest.TestReport, pytest.TestReport]:
    report = yield
    running = getattr(item, "funcargs", {}).get("simulator")
    if call.when == "call" and report.failed and isinstance(running, Simulator):
        page = item.config.rootpath / _REPORTS / (re.sub(r"[^\w.-]+", "-", item.nodeid) + ".html")
        item.stash[_report_file] = page
        item.user_properties.append(("tello-report", str(page)))
        report.user_properties.append(("tello-report", str(page)))
        report.sections.append(("drones", f"{running.explanation()}\n\nreport: {page}"))
    return report
