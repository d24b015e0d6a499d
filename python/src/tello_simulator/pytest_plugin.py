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
import warnings
from collections.abc import Generator, Iterator
from pathlib import Path
from typing import Any, Optional

import pytest

from ._control import SimulatorError
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


class _SimulatorCache:
    """Keeps a simulator running for the next tests with the same settings."""

    def __init__(self, recordings: Path) -> None:
        self._recordings = recordings
        self._settings: Optional[str] = None
        self._running: Optional[Simulator] = None

    def simulator(self, *settings: object, **named: Any) -> Simulator:
        key = repr((settings, sorted(named.items())))
        if self._running is not None and key == self._settings:
            try:
                self._running.reset()
                return self._running
            except SimulatorError:
                pass  # it has ended, for example because a test has killed it
        self.close()
        self._running = Simulator(*settings, record=self._recordings, **named)  # type: ignore[arg-type]
        self._settings = key
        return self._running

    def flights(self) -> list[Path]:
        """Return the folders of the recorded flights, the oldest first."""
        return sorted((file for file in self._recordings.iterdir() if file.is_dir()), key=lambda folder: folder.stat().st_mtime)

    def close(self) -> None:
        if self._running is not None:
            self._running.close()
            self._running = None


@pytest.fixture(scope="session")
def _tello_simulators(tmp_path_factory: pytest.TempPathFactory) -> Iterator[_SimulatorCache]:
    cache = _SimulatorCache(tmp_path_factory.mktemp(_REPORTS))
    yield cache
    cache.close()


@pytest.fixture
def simulator(request: pytest.FixtureRequest, _tello_simulators: _SimulatorCache) -> Iterator[Simulator]:
    """A simulator that has just been reset, with the settings of the marker `tello`."""
    marker = request.node.get_closest_marker(_MARKER) or pytest.mark.tello().mark
    cache = _tello_simulators
    running = cache.simulator(*marker.args, **marker.kwargs)
    before = set(cache.flights())
    yield running
    page = request.node.stash.get(_report_file, None)
    if page is not None:
        try:
            running.reset()  # completes the recording
        except SimulatorError:
            pass  # it has ended, which completes the recording, too
        flights = [flight for flight in cache.flights() if flight not in before]
        if flights:
            page.parent.mkdir(exist_ok=True)
            try:
                write_report(flights[-1], page)
            except SimulatorError as error:
                warnings.warn(f"there is no report of {request.node.nodeid}: {error}")


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
        try:
            explanation = running.explanation()
        except SimulatorError as error:
            explanation = str(error)
        report.sections.append(("drones", f"{explanation}\n\nreport: {page}"))
    return report
