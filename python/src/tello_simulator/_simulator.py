"""A simulator in its own process, started and asked from Python."""

from __future__ import annotations

import os
import re
import socket
import subprocess
import tempfile
import threading
from collections.abc import Iterable
from types import TracebackType
from typing import IO, Optional, Union

from . import _java
from ._control import ControlChannel, SimulatorError
from ._values import Goals, JournalEntry, Truth

# A wall-clock limit for the end of the process, after which it is killed. Decided: recordings of a
# long flight are written by then.
_END_SECONDS = 20.0

_CONTROL_LINE = re.compile(r"control: ([0-9.]+):([0-9]+) token ([0-9a-f]+)\s*")

StrPath = Union[str, "os.PathLike[str]"]


class Drone:
    """A simulated drone. Programs reach it at `host` and `command_port` by UDP, and receive its
    state and video on `state_port` and `video_port`, as with a real drone on 8889, 8890 and 11111.

    Lengths are centimetres, angles degrees clockwise.
    """

    def __init__(
        self,
        channel: ControlChannel,
        number: int,
        host: str,
        command_port: int,
        state_port: int,
        video_port: int,
    ) -> None:
        self._channel = channel
        self.number = number
        self.host = host
        self.command_port = command_port
        self.state_port = state_port
        self.video_port = video_port

    @property
    def address(self) -> tuple[str, int]:
        """Where the drone takes commands, as `socket.sendto` wants it."""
        return self.host, self.command_port

    def truth(self) -> Truth:
        """Return the true state of the drone, and what it has done since the last reset."""
        return Truth.of(self._channel.ask("truth", drone=self.number))

    def journal(self) -> list[JournalEntry]:
        """Return all texts that reached the drone since the last reset, with their replies."""
        return [JournalEntry.of(entry) for entry in self._channel.ask("journal", drone=self.number)]

    def commands(self) -> list[str]:
        """Return the texts of the journal."""
        return [entry.text for entry in self.journal()]

    def faults(self) -> list[str]:
        """Return the active faults of the drone."""
        return list(self._channel.ask("faults", drone=self.number))

    def battery(self, percent: float) -> None:
        """Charge or drain the battery to 0 to 100 %."""
        self._channel.ask("battery", drone=self.number, percent=percent)

    def place(self, x: float, y: float, heading: float = 0) -> None:
        """Move the drone's start, and the drone too if it is on the ground."""
        self._channel.ask("place", drone=self.number, x=x, y=y, heading=heading)

    def power(self, on: bool) -> None:
        """Switch the drone on or off."""
        self._channel.ask("power", drone=self.number, on=on)

    def await_command(self, command: str, timeout: float = 30) -> JournalEntry:
        """Wait until the drone has received and answered a command.

        Args:
            timeout: seconds of wall-clock time, after which SimulatorError is raised.
        """
        return JournalEntry.of(
            self._channel.ask("await", drone=self.number, command=command, timeout=timeout)
        )

    def __repr__(self) -> str:
        return f"<drone {self.number} at {self.host}:{self.command_port}>"


class Simulator:
    """A simulator without a window, in a process of its own.

    With the default time factor, simulated time passes only while a drone has something to do, as
    fast as the machine can, so tests need not sleep.

        with Simulator("gate-race", seed=7) as simulator:
            fly(*simulator.drone.address)  # your program
            assert simulator.drone.truth().landed

    Not thread-safe.

    Args:
        scenario: a scenario file, or the name of a built-in scenario; without it, an empty room.
        drones: how many drones to simulate, unless a scenario says so.
        profile: edu, tello or tt.
        behaviour: report, or measured with the noise and the radio link of a real drone.
        seed: the seed of everything random.
        link: ideal, lab, classroom or crowded.
        faults: faults that act from the start, such as "loss state 20% for 10s".
        time_factor: how fast time passes, or "max".
        record: a folder in which each flight is recorded.
        command_port: 0 for a free port.
        state_port: the port on which your program receives the state; without it, a free one.
        video_port: the port on which your program receives the video; without it, a free one.
        options: further options of the command line.

    Raises:
        SimulatorError: the simulator did not start; the message says why.
        FileNotFoundError: Java or the simulator's jar is missing.
    """

    def __init__(
        self,
        scenario: Optional[StrPath] = None,
        *,
        drones: Optional[int] = None,
        profile: Optional[str] = None,
        behaviour: Optional[str] = None,
        seed: Optional[int] = None,
        link: Optional[str] = None,
        faults: Iterable[str] = (),
        time_factor: Union[float, str] = "max",
        record: Optional[StrPath] = None,
        command_port: int = 0,
        state_port: Optional[int] = None,
        video_port: Optional[int] = None,
        options: Iterable[str] = (),
    ) -> None:
        free_state, free_video = _free_ports(2)
        settings: dict[str, object] = {
            "--control": 0,
            "--log-level": "error",
            "--time-factor": time_factor,
            "--command-port": command_port,
            "--state-port": free_state if state_port is None else state_port,
            "--video-port": free_video if video_port is None else video_port,
            "--scenario": scenario if scenario is None else os.fspath(scenario),
            "--drones": drones,
            "--profile": profile,
            "--behaviour": behaviour,
            "--seed": seed,
            "--link": link,
            "--record": record if record is None else os.fspath(record),
        }
        arguments = ["--headless"]
        for name, value in settings.items():
            if value is not None:
                arguments += [name, str(value)]
        for fault in faults:
            arguments += ["--fault", fault]
        self._process = _Process([*arguments, *options])
        try:
            self._channel = self._process.connect()
            #: The link to the page in a browser; None without the option --web.
            self.page = self._process.page
            self.drones: tuple[Drone, ...] = tuple(
                Drone(
                    self._channel,
                    one["drone"],
                    one["host"],
                    one["commandPort"],
                    one["statePort"],
                    one["videoPort"],
                )
                for one in self._channel.ask("drones")
            )
        except BaseException:
            self._process.end()
            raise

    @property
    def drone(self) -> Drone:
        """The first drone."""
        return self.drones[0]

    def goals(self) -> Goals:
        """Return the progress towards the goals of the scenario."""
        return Goals.of(self._channel.ask("goals"))

    def explanation(self) -> str:
        """Return what happened, in words: commands, states of the drones, goals and journals."""
        return str(self._channel.ask("explanation"))

    def inject(self, fault: str) -> None:
        """Let something go wrong, such as "loss replies 20% for 10s"."""
        self._channel.ask("inject", fault=fault)

    def clear_faults(self) -> None:
        """End all faults."""
        self._channel.ask("clear-faults")

    def link(self, preset: str) -> None:
        """Set how good the link is: ideal, lab, classroom or crowded."""
        self._channel.ask("link", preset=preset)

    def wind(self, speed: float, towards: float = 0) -> None:
        """Set the wind: 0 to 2000 cm/s, towards an angle of the room."""
        self._channel.ask("wind", speed=speed, towards=towards)

    def reset(self) -> None:
        """Start again: same places, full batteries, no faults, empty journals."""
        self._channel.ask("reset")

    def advance(self, seconds: float) -> None:
        """Let simulated time pass while your program waits for no reply."""
        self._channel.ask("advance", seconds=seconds)

    def await_still(self, timeout: float = 30) -> None:
        """Wait until all commands are completed and nothing moves except hovering drones.

        Args:
            timeout: seconds of wall-clock time, after which SimulatorError is raised.
        """
        self._channel.ask("await-still", timeout=timeout)

    def await_goals(self, timeout: float = 30) -> Goals:
        """Wait until all goals are reached.

        Args:
            timeout: seconds of wall-clock time, after which SimulatorError is raised.
        """
        return Goals.of(self._channel.ask("await-goals", timeout=timeout))

    def close(self) -> None:
        """End the simulator. Recordings are complete afterwards. A second call has no effect."""
        self._channel.close()
        self._process.end()

    def __enter__(self) -> Simulator:
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.close()


class _Process:
    """The simulator's process."""

    def __init__(self, arguments: list[str]) -> None:
        command = _java.command(arguments)
        self.page: Optional[str] = None
        self._drain: Optional[threading.Thread] = None
        self._errors: IO[bytes] = tempfile.TemporaryFile()
        self._process = subprocess.Popen(
            command,
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            stderr=self._errors,
            encoding="utf-8",
            errors="replace",
        )

    def connect(self) -> ControlChannel:
        """Wait until the simulator is ready, and connect to its control channel."""
        control: Optional[re.Match[str]] = None
        assert self._process.stdout is not None
        for line in self._process.stdout:
            control = control or _CONTROL_LINE.fullmatch(line)
            if line.startswith("web: "):
                self.page = line.removeprefix("web: ").strip()
            if line.startswith("ready") and control:
                # What else it prints must be read, or the simulator would wait.
                self._drain = threading.Thread(target=self._process.stdout.read, daemon=True)
                self._drain.start()
                host, port, token = control.groups()
                return ControlChannel(host, int(port), token)
        code = self._process.wait()
        self._errors.seek(0)
        said = self._errors.read().decode("utf-8", "replace").strip()
        raise SimulatorError(said or f"the simulator ended with exit code {code}")

    def end(self) -> None:
        if self._errors.closed:
            return
        assert self._process.stdin is not None and self._process.stdout is not None
        try:
            self._process.stdin.write("quit\n")
            self._process.stdin.close()
        except OSError:
            pass  # it has ended already
        try:
            self._process.wait(_END_SECONDS)
        except subprocess.TimeoutExpired:
            self._process.kill()
            self._process.wait()
        if self._drain is not None:
            self._drain.join()
        self._process.stdout.close()
        self._errors.close()


def _free_ports(count: int) -> list[int]:
    """Return UDP ports of the loopback address that are free now."""
    probes = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(count)]
    try:
        for probe in probes:
            probe.bind(("127.0.0.1", 0))
        return [probe.getsockname()[1] for probe in probes]
    finally:
        for probe in probes:
            probe.close()


def write_report(recording: StrPath, file: StrPath) -> None:
    """Write a report of a recorded flight: an HTML page that opens in any browser.

    Args:
        recording: the folder of one flight, as `record` makes it.
        file: the page to write.

    Raises:
        SimulatorError: the recording cannot be read, or the page cannot be written.
    """
    words = _java.command(["report", os.fspath(recording), "--output", os.fspath(file)])
    done = subprocess.run(words, capture_output=True, encoding="utf-8", errors="replace", check=False)
    if done.returncode != 0:
        raise SimulatorError(done.stderr.strip())
