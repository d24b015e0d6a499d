"""What the simulator knows of a flight. Lengths are centimetres, angles degrees clockwise, times
seconds of the simulation; x is along the room's depth, y to the left, z up."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional

Position = tuple[float, float, float]
"""x, y and z [cm]."""


@dataclass(frozen=True)
class Touch:
    """A contact with something: a name, the time, the speed [cm/s], and whether it was a crash."""

    what: str
    seconds: float
    speed: float
    crash: bool


@dataclass(frozen=True)
class Truth:
    """The true state of a drone and what it has done since the last reset."""

    x: float
    y: float
    z: float
    height: float
    heading: float
    battery: int
    flying: bool
    landed: bool
    crashed: bool
    takeoffs: int
    touched: tuple[Touch, ...]
    visited: tuple[str, ...]
    highest: float
    farthest: float
    start: Position
    path: tuple[Position, ...]

    @property
    def position(self) -> Position:
        return self.x, self.y, self.z

    @classmethod
    def of(cls, values: dict[str, Any]) -> Truth:
        known = dict(values)
        known["touched"] = tuple(Touch(**touch) for touch in values["touched"])
        known["visited"] = tuple(values["visited"])
        known["start"] = tuple(values["start"])
        known["path"] = tuple(tuple(place) for place in values["path"])
        return cls(**known)


@dataclass(frozen=True)
class Reply:
    """A reply, and the time from the command to it."""

    text: str
    delay: float


@dataclass(frozen=True)
class JournalEntry:
    """A text that reached a drone, with what became of it.

    `outcome` is taken, answered, refused, failed, lost, ignored or turned-away; `reply` is
    empty while there is none; `explanation` says why a command was refused, lost or ignored.
    """

    text: str
    sender: str
    seconds: float
    outcome: str
    reply: str
    replies: tuple[Reply, ...]
    explanation: str

    @classmethod
    def of(cls, values: dict[str, Any]) -> JournalEntry:
        known = dict(values)
        known["replies"] = tuple(Reply(**reply) for reply in values["replies"])
        return cls(**known)


@dataclass(frozen=True)
class ScoreEntry:
    """Points that were won or lost, when, and why."""

    seconds: float
    points: float
    why: str


@dataclass(frozen=True)
class Score:
    """The points of a scenario: won so far, at most, and each change."""

    points: float
    of: float
    entries: tuple[ScoreEntry, ...]


@dataclass(frozen=True)
class Goals:
    """The goals of a scenario: the verdict, its reason, and which goals are done and open."""

    reached: bool
    failed: bool
    reason: str
    done: tuple[str, ...]
    open: tuple[str, ...]
    seconds: float
    score: Optional[Score]

    @classmethod
    def of(cls, values: dict[str, Any]) -> Goals:
        known = dict(values)
        known["done"] = tuple(values["done"])
        known["open"] = tuple(values["open"])
        score = values.get("score")
        known["score"] = score and Score(
            score["points"], score["of"], tuple(ScoreEntry(**entry) for entry in score["entries"])
        )
        return cls(**known)
