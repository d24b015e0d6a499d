"""Simulated Tello drones, which programs fly over UDP as they fly real ones.

`Simulator` starts a simulator without a window and asks it what its drones do. The pytest plugin of
this package gives a fresh one to each test. `tello-simulator` starts the program itself.
"""

from ._control import SimulatorError
from ._notebook import NotebookFlight, notebook
from ._simulator import Drone, Simulator, write_report
from ._values import Goals, JournalEntry, Position, Reply, Score, ScoreEntry, Touch, Truth

__all__ = [
    "Drone",
    "Goals",
    "JournalEntry",
    "NotebookFlight",
    "Position",
    "Reply",
    "Score",
    "ScoreEntry",
    "Simulator",
    "SimulatorError",
    "Touch",
    "Truth",
    "notebook",
    "write_report",
]
