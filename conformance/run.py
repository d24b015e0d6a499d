#!/usr/bin/env python3
"""Flies unmodified client packages against the simulator and judges every reply and position."""

import argparse
import contextlib
import dataclasses
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import threading
import time

import network
from judge import Judge
from shim import Shim
from simulator import Proxy, Simulator

HERE = pathlib.Path(__file__).resolve().parent
INSIDE = "TELLO_CONFORMANCE_NETWORK"

MARKER = HERE.parent / "examples" / "marker.png"

FAILED = 1
MISSING = 77
FORBIDDEN = 78

LONGEST_FLIGHT_S = 60
LONGEST_FLIGHT_WITH_FAULTS_S = 240
LOOPBACK = ("127.0.0.1", "8879")
BEHIND_PROXY = "127.0.0.2"


def python():
    inside = "Scripts/python.exe" if os.name == "nt" else "bin/python"
    own = HERE / ".venv" / inside
    return str(own) if own.exists() else sys.executable


HALL = ["--room", "2000x2000x400"]  # so large that nobody reaches a wall
GALLERY = [  # a metre and a half from a wall on which pictures hang
    *("--start", "96.5,-20"),
    *("--poster", f"front,20,80,24,{MARKER}"),
    *("--poster", f"front,-40,80,16,{HERE / 'red.png'}"),
]
# What each client says in its program that repeats commands; see persist_*.
TEN = [
    "command", "takeoff", "up 30", "forward 50", "cw 90", "left 30", "right 30", "ccw 90",
    "back 50", "land",
]  # fmt: skip
SEARCH = ["--poster", f"right,-60,100,40,{MARKER}"]


class Client:
    """How a client is started, how to see whether it is installed, and in which room it flies."""

    def __init__(
        self,
        start,
        probe,
        install,
        room=HALL,
        time_factor="5",
        fewest_steps=15,
        drones=1,
        persistent=(),
        real_address=False,
        given_address=False,
        shimmed=True,
    ):
        self.start, self.probe, self.install = start, probe, install
        self.room, self.time_factor, self.fewest_steps = room, time_factor, fewest_steps
        self.drones = drones
        self.persistent = persistent
        self.real_address = real_address or drones > 1
        self.given_address = given_address
        self.shimmed = shimmed

    def flies(self, chosen):
        """Whether it can reach its drones: some accept no other address, and a proxy serves one."""
        if chosen.proxy and self.drones > 1:
            return False
        if chosen.shim and not self.shimmed:
            return False
        if chosen.private_network or chosen.shim:
            return not self.given_address
        return not self.real_address

    def missing(self):
        """Why it cannot fly; empty if it can."""
        if shutil.which(self.start[0]) is None:
            return f"{self.start[0]} is not installed"
        tried = subprocess.run([self.start[0], *self.probe], cwd=HERE, capture_output=True)
        return "" if tried.returncode == 0 else f"its package is missing: {self.install}"


PIP = "pip install -r conformance/requirements.txt"
NPM = "npm install --prefix conformance"
GO = "cd conformance/go && go build ./..."
OLD_TELLOPY = "import importlib.metadata as m; assert m.version('tellopy') == '0.6.0'"

CLIENTS = {
    "djitellopy": Client(
        [python(), "fly_djitellopy.py"],
        ["-c", "import djitellopy"],
        PIP,
        persistent=[python(), "persist_djitellopy.py"],
    ),
    "djitellopy-video": Client(
        [python(), "film_djitellopy.py"],
        ["-c", "import djitellopy, cv2.aruco"],
        PIP,
        room=GALLERY,
        time_factor="1",
    ),
    "find_marker": Client(
        [python(), "fly_find_marker.py"],
        ["-c", "import djitellopy, cv2.aruco"],
        PIP,
        room=SEARCH,
        time_factor="1",
        fewest_steps=3,
        given_address=True,
    ),
    "djitellopy-swarm": Client(
        [python(), "fly_swarm.py"],
        ["-c", "import djitellopy"],
        PIP,
        fewest_steps=5,
        drones=3,
    ),
    "tello-asyncio": Client(
        [python(), "fly_tello_asyncio.py"],
        ["-c", "import tello_asyncio"],
        PIP,
        persistent=[python(), "persist_tello_asyncio.py"],
    ),
    "easytello": Client(
        [python(), "fly_easytello.py"],
        ["-c", "import easytello"],
        PIP,
        real_address=True,
    ),
    "ros-driver": Client(
        [python(), "fly_ros_driver.py"],
        ["-c", ""],
        PIP,
        time_factor="1",
        fewest_steps=10,
    ),
    "tellopy": Client(
        [python(), "fly_tellopy.py"],
        ["-c", "import av, PIL, tellopy"],
        PIP,
        time_factor="1",
    ),
    "tellopy-0.6": Client(
        ["env", f"PYTHONPATH={HERE / 'tellopy-0.6'}", python(), "fly_tellopy.py"],
        [f"PYTHONPATH={HERE / 'tellopy-0.6'}", python(), "-c", OLD_TELLOPY],
        "pip install --no-deps --target conformance/tellopy-0.6 tellopy==0.6.0",
        time_factor="1",
        fewest_steps=14,
    ),
    "like-ctello": Client(
        [python(), "fly_like_ctello.py"],
        ["-c", ""],
        PIP,
        time_factor="1",
        fewest_steps=11,
    ),
    "gobot": Client(
        ["go", "run", "-C", "go", "./gobot"],
        ["build", "-C", "go", "-o", os.devnull, "./gobot"],
        GO,
        time_factor="1",
        fewest_steps=10,
        real_address=True,
        shimmed=False,
    ),
    "smerrony": Client(
        ["go", "run", "-C", "go", "./smerrony"],
        ["build", "-C", "go", "-o", os.devnull, "./smerrony"],
        GO,
        # its autopilot expects a real drone's sticks
        room=[*HALL, "--behaviour", "measured", "--link", "ideal"],
        time_factor="1",
        shimmed=False,
    ),
    "rust-tello": Client(
        ["cargo", "run", "--quiet", "--manifest-path", "rust/Cargo.toml", "--"],
        ["build", "--quiet", "--manifest-path", "rust/Cargo.toml"],
        "cd conformance/rust && cargo build",
        time_factor="1",
        fewest_steps=11,
        shimmed=False,
    ),
    "tello-drone": Client(
        ["node", "fly_tello_drone.js"],
        ["-e", "require.resolve('tello-drone')"],
        NPM,
        real_address=True,
    ),
    "tellojs": Client(
        ["node", "fly_tellojs.js"],
        ["-e", "require.resolve('tellojs')"],
        NPM,
        persistent=["node", "persist_tellojs.js"],
    ),
}


def options():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument(
        "clients", nargs="*", metavar="client", help="which to fly: " + ", ".join(CLIENTS)
    )
    parser.add_argument(
        "--private-network",
        action="store_true",
        help="fly without any change, over a network in which the drone is 192.168.10.1:8889",
    )
    parser.add_argument(
        "--shim",
        action="store_true",
        help="fly without any change, by the shim in a network that is not private",
    )
    parser.add_argument(
        "--proxy",
        action="store_true",
        help="with --private-network: a proxy is there in its place, and the drone behind it",
    )
    parser.add_argument(
        "--time-factor", help="how fast time passes, or max; 5, with video 1, unless given"
    )
    parser.add_argument(
        "--fault",
        action="append",
        default=[],
        help="fly ten commands, each until the drone has carried it out, while this goes wrong; "
        "once for each",
    )
    parser.add_argument("--java", default="java", help="which Java runs the simulator")
    parser.add_argument("--jar", default=str(HERE.parent / "target" / "tello-simulator.jar"))
    chosen = parser.parse_args()
    unknown = [name for name in chosen.clients if name not in CLIENTS]
    if unknown:
        parser.error("there is no client " + ", ".join(unknown))
    if chosen.proxy and not chosen.private_network:
        parser.error("a proxy takes --private-network")
    if chosen.shim and chosen.private_network:
        parser.error("a private network needs no shim")
    if not chosen.clients:
        chosen.clients = [name for name, client in CLIENTS.items() if client.flies(chosen)]
    lost = [name for name in chosen.clients if not CLIENTS[name].flies(chosen)]
    if lost:
        parser.error("these clients cannot reach their drones in this way: " + ", ".join(lost))
    if chosen.fault and not chosen.private_network:
        parser.error("faults take --private-network, in which clients are as they are")
    stubborn = [name for name in chosen.clients if not CLIENTS[name].persistent]
    if chosen.fault and stubborn:
        parser.error("no program repeats commands with " + ", ".join(stubborn))
    return chosen


def persist(name, fault, chosen):
    """Whether ten commands were carried out and the drone has landed, in spite of a fault."""
    client = CLIENTS[name]
    started = time.monotonic()
    with contextlib.ExitStack() as stack:
        cable = stack.enter_context(network.PrivateNetwork())
        simulator_options = [
            *("--time-factor", chosen.time_factor or "1", *client.room),
            *("--bind", network.DRONES[0], "--command-port", "8889"),
            *("--fault", fault, "--seed", "1"),
        ]
        simulator = stack.enter_context(Simulator(chosen.java, chosen.jar, simulator_options))
        command = cable.way_in() + list(client.persistent)
        faults, chatter = follow(command, None, simulator, LONGEST_FLIGHT_WITH_FAULTS_S)
        log = simulator.log()
        faults += [f"{text} was never carried out" for text in TEN if not carried_out(text, log)]
        if simulator.pose_at_rest().z > 0:
            faults.append("the drone still flies")
        commands = sum(log.count(f"`{text}` from") for text in TEN)
        seconds = time.monotonic() - started
        end = f"{commands} commands came for {len(TEN)}, {seconds:.1f} s"
        if not faults:
            print(f"{name} with {fault}: passed, {end}", flush=True)
            return True
        print(f"{name} with {fault}: FAILED, {end}")
        print("\n".join("  " + each for each in faults))
        print("What the client wrote last:", *chatter[-20:], sep="\n  ")
        print("What the simulator wrote last:", *log.splitlines()[-40:], sep="\n  ", flush=True)
        return False


def carried_out(text, log):
    return f"`{text}` answered `ok`" in log


def fly(name, chosen, table):
    """Whether all went well; adds a row to the table."""
    place = "private network" if chosen.private_network else "loopback"
    if chosen.shim:
        place = "loopback and a shim"
    if chosen.proxy:
        place += " and a proxy"
    client = CLIENTS[name]
    time_factor = chosen.time_factor or client.time_factor
    print(f"{name} over {place}, time factor {time_factor}", flush=True)
    started = time.monotonic()
    with contextlib.ExitStack() as stack:
        simulator_options = ["--time-factor", time_factor, *client.room]
        command = list(client.start)
        if chosen.private_network:
            cable = stack.enter_context(network.PrivateNetwork())
            drones = ",".join(network.DRONES[: client.drones])
            if chosen.proxy:
                drones = BEHIND_PROXY
            simulator_options += ["--bind", drones, "--command-port", "8889"]
            command = cable.way_in() + command
        elif chosen.shim:
            simulator_options += ["--drones", str(client.drones), "--port-per-drone"]
        else:
            command += LOOPBACK
        if time_factor == "max":
            command.append("--at-full-speed")
        simulator = stack.enter_context(Simulator(chosen.java, chosen.jar, simulator_options))
        if chosen.proxy:
            proxy_options = ["--drone", BEHIND_PROXY, "--bind", network.DRONES[0]]
            stack.enter_context(Proxy(chosen.java, chosen.jar, proxy_options))
        environment = {}
        if chosen.shim:
            environment = stack.enter_context(Shim(chosen.jar, simulator.ready))
        judge = Judge(simulator)
        faults, chatter = follow(command, judge, simulator, environment=environment)
        if judge.steps < client.fewest_steps:
            faults.append(f"fewer than {client.fewest_steps} steps")
        seconds = time.monotonic() - started
        end = f"{judge.steps} steps, at most {judge.worst_cm:.1f} cm off, {seconds:.1f} s"
        verdict = "FAILED" if faults else "passed"
        table.append(f"| {name} | {place} | {verdict} | {end} |")
        if not faults:
            print(f"{name} over {place}: passed, {end}\n", flush=True)
            return True
        print(f"{name} over {place}: FAILED, {end}")
        print("\n".join("  " + fault for fault in faults))
        print("What the client wrote last:", *chatter[-20:], sep="\n  ")
        log = simulator.log().splitlines()
        print("What the simulator wrote last:", *log[-40:], sep="\n  ", flush=True)
        return False


def follow(command, judge, simulator, longest_s=LONGEST_FLIGHT_S, environment=None):
    """Runs a client; returns what went wrong, and what it wrote of its own accord."""
    client = subprocess.Popen(
        command,
        cwd=HERE,
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        encoding="utf-8",
        bufsize=1,
        env={
            **os.environ,
            "PYTHONUNBUFFERED": "1",
            "PYTHONDONTWRITEBYTECODE": "1",
            **(environment or {}),
        },
    )
    watch = threading.Timer(longest_s, lambda: (client.kill(), simulator.kill()))
    watch.start()
    faults, chatter, done = [], [], False
    try:
        for line in client.stdout:
            if line.startswith("step "):
                faults += take(line, judge, client)
            elif line.rstrip() == "done":
                done = True
            else:
                chatter.append(line.rstrip())
    finally:
        watch.cancel()
        client.kill()
        client.wait()
    if not done:
        faults.append("the client did not come to its end")
    return faults, chatter


def take(line, judge, client):
    """Judges a step, prints it and answers the client with the drone's pose."""
    step = json.loads(line.removeprefix("step "))
    pose, faults = judge.judge(step)
    reply = step["reply"].replace("\r", "\\r").replace("\n", "\\n")
    verdict = "WRONG" if faults else "right"
    print(f"  {verdict} {step['command']:28} {pose}  {'; '.join([reply, *faults])}", flush=True)
    try:
        client.stdin.write(json.dumps(dataclasses.asdict(pose)) + "\n")
    except BrokenPipeError:
        faults.append("the client ended too early")
    return [f"{step['command']}: {fault}" for fault in faults]


def what_is_missing(chosen):
    missing = [
        f"{name}: {reason}" for name in chosen.clients if (reason := CLIENTS[name].missing())
    ]
    if not pathlib.Path(chosen.jar).exists():
        missing.append(f"{chosen.jar} is missing: mvn -DskipTests package")
    if chosen.private_network and sys.platform == "linux":
        missing += [f"{tool} is not installed" for tool in network.missing_tools()]
    return missing


def enter_network(chosen):
    """Goes on in a network of its own; returns only if that cannot be had.

    Flights over the loopback need none, but with one they need no free ports on this machine.
    """
    if sys.platform != "linux":
        reason = "it takes the network name spaces of Linux"
    elif network.missing_tools():
        reason = "it takes " + ", ".join(network.TOOLS)
    else:
        way, reason = network.way_in()
        if way:
            os.environ[INSIDE] = "1"
            sys.stdout.flush()
            os.execvp(way[0], [*way, sys.executable, *sys.argv])
    if chosen.private_network:
        print("skipped: the kernel forbids a private network: " + reason)
        sys.exit(FORBIDDEN)


def main():
    chosen = options()
    network.add_system_tools_to_path()
    missing = what_is_missing(chosen)
    if missing:
        print("skipped: " + "; ".join(missing))
        return MISSING
    signal.signal(signal.SIGTERM, lambda *_: sys.exit("ended from outside"))
    if INSIDE in os.environ:
        network.loopback_up()
    else:
        enter_network(chosen)
    table = ["| client | place | verdict | |", "|---|---|---|---|"]
    flights = [fly(name, chosen, table) for name in chosen.clients if not chosen.fault]
    if flights:
        print(*table, sep="\n", flush=True)
    flights += [persist(name, fault, chosen) for name in chosen.clients for fault in chosen.fault]
    return 0 if all(flights) else FAILED


if __name__ == "__main__":
    sys.exit(main())
