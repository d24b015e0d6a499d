"""The simulator in a cell of a notebook."""

from __future__ import annotations

import importlib
import os
import socket
from types import TracebackType
from typing import Any, Optional
from urllib.parse import urlsplit

from ._simulator import Simulator, StrPath, _free_ports


class NotebookFlight:
    """A simulator whose page is in a notebook, and an operator of its first drone.

        flight = tello_simulator.notebook("gate-race")
        flight.send("takeoff")
        flight.send("forward 100")

    Not thread-safe.
    """

    def __init__(self, simulator: Simulator) -> None:
        self.simulator = simulator
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.connect(simulator.drone.address)
        self._entered = False

    def send(self, command: str, timeout: float = 30) -> str:
        """Send a command as an operator program does, and return the reply.

        Raises:
            TimeoutError: the drone does not reply in time.
        """
        if not self._entered and command != "command":
            self._entered = self.send("command", timeout) == "ok"
        self._forget_late_replies()
        self._socket.settimeout(timeout)
        self._socket.send(command.encode())
        return self._socket.recv(1024).decode("utf-8", "replace")

    def _forget_late_replies(self) -> None:
        self._socket.setblocking(False)
        try:
            while True:
                self._socket.recv(1024)
        except OSError:
            pass  # there are no more

    def close(self) -> None:
        """End the simulator, and with it the page. A second call has no effect."""
        self._socket.close()
        self.simulator.close()

    def __enter__(self) -> NotebookFlight:
        return self

    def __exit__(
        self,
        kind: Optional[type[BaseException]],
        error: Optional[BaseException],
        trace: Optional[TracebackType],
    ) -> None:
        self.close()


def notebook(scenario: Optional[StrPath] = None, *, height: int = 720, **settings: Any) -> NotebookFlight:
    """Start a simulator, show its page below the cell, and return an object to fly with.

    Args:
        scenario: a scenario file, or the name of a built-in scenario; without it, an empty room.
        height: the height of the page in pixels.
        settings: further settings of `Simulator`. Time passes as it does for people.

    Raises:
        ImportError: IPython is missing, so this is no notebook.
        SimulatorError: the simulator did not start; the message says why.
    """
    ipython: Any = importlib.import_module("IPython.display")

    settings = {"time_factor": 1, "command_port": _free_ports(1)[0], **settings}
    options = [*settings.pop("options", ()), "--web", "0"]
    simulator = Simulator(scenario, options=options, **settings)
    try:
        page = _reachable(str(simulator.page))
        ipython.display(ipython.IFrame(page, width="100%", height=height))
        return NotebookFlight(simulator)
    except BaseException:
        simulator.close()
        raise


def _reachable(page: str) -> str:
    """Return the link for a browser that may be on another machine, behind JupyterHub's proxy."""
    prefix = os.environ.get("JUPYTERHUB_SERVICE_PREFIX")
    if prefix is None:
        return page
    link = urlsplit(page)
    return f"{prefix.rstrip('/')}/proxy/{link.port}/?{link.query}"
