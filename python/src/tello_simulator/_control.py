"""The simulator's control channel: one JSON object per line over TCP."""

from __future__ import annotations

import json
import socket
from typing import Any

# The simulator answers within its own time-outs, of at most an hour each; this is only for a
# simulator that has stopped without closing the connection.
_LONGEST_ANSWER_SECONDS = 3700.0


class SimulatorError(Exception):
    """The simulator did not start, has ended, or refused a request. The message says why."""


class ControlChannel:
    """A connection to a simulator that was started with `--control`. Not thread-safe."""

    def __init__(self, host: str, port: int, token: str) -> None:
        self._token = token
        self._socket = socket.create_connection((host, port), _LONGEST_ANSWER_SECONDS)
        self._answers = self._socket.makefile("r", encoding="utf-8")

    def ask(self, request: str, **parameters: object) -> Any:
        """Send a request and return its result once the simulator has carried it out.

        Raises:
            SimulatorError: the request was refused, or the simulator has ended.
        """
        if self._socket.fileno() < 0:
            raise SimulatorError(f"the simulator is closed, so it cannot answer `{request}`")
        line = json.dumps({"token": self._token, "do": request, **parameters})
        try:
            self._socket.sendall(line.encode() + b"\n")
            text = self._answers.readline()
        except OSError as error:
            raise SimulatorError(f"the simulator does not answer `{request}`: {error}") from error
        if not text:
            raise SimulatorError(f"the simulator ended before it answered `{request}`")
        answer = json.loads(text)
        if not answer["ok"]:
            raise SimulatorError(answer["error"])
        return answer["result"]

    def close(self) -> None:
        self._answers.close()
        self._socket.close()
