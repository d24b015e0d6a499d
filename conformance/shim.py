"""The shim that gives a program the addresses of real drones, see `run --shim`, taken from the jar."""

import os
import pathlib
import re
import tempfile
import zipfile

import network

LIBRARIES = ("sitecustomize.py", "shim.js")
LISTENING = re.compile(r"drone \d+ at (\S+:\d+)")


class Shim:
    """From `with` to the end of its block."""

    def __init__(self, jar, ready):
        self._jar = jar
        pairs = zip(network.DRONES, LISTENING.findall(ready.replace(";", " ")))
        self._pairs = ",".join(f"{drone}:8889={simulated}" for drone, simulated in pairs)
        self._folder = tempfile.TemporaryDirectory()

    def __enter__(self):
        folder = pathlib.Path(self._folder.name)
        with zipfile.ZipFile(self._jar) as jar:
            for name in LIBRARIES:
                folder.joinpath(name).write_bytes(jar.read(f"tellosimulator/launcher/{name}"))
        return {
            "TELLO_SIMULATOR_SHIM": self._pairs,
            "PYTHONPATH": os.pathsep.join(filter(None, [str(folder), os.getenv("PYTHONPATH")])),
            "NODE_OPTIONS": f'--require "{folder / "shim.js"}"',
        }

    def __exit__(self, *failure):
        self._folder.cleanup()
