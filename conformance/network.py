"""Network name spaces of our own: a user's, without root, where the kernel allows it."""

import os
import shutil
import subprocess

DRONES = ("192.168.10.1", "192.168.10.3", "192.168.10.4")
CLIENT = "192.168.10.2"
MASK = "24"

TOOLS = ("unshare", "nsenter", "ip")
PROBE = "ip link set lo up && ip link add probe type veth peer name eborp"

WAYS_IN = (["unshare", "--user", "--map-root-user", "--net"], ["unshare", "--net"])


def missing_tools():
    return [tool for tool in TOOLS if shutil.which(tool) is None]


def way_in():
    """The command that starts another one in a network of its own.

    Returns it and an empty text, or None and the reason why the kernel does not let us.
    """
    reasons = []
    for way in WAYS_IN:
        tried = subprocess.run([*way, "sh", "-c", PROBE], capture_output=True, text=True)
        if tried.returncode == 0:
            return way, ""
        reasons.append(" ".join(way) + ": " + " ".join(tried.stderr.split()))
    return None, "; ".join(reasons)


def loopback_up():
    _ip("link", "set", "lo", "up")


class PrivateNetwork:
    """A second name space for the client, on the other end of a cable to this one.

    From `with` to the end of its block; this process is already in a name space of its own.
    """

    def __init__(self):
        self._keeper = None

    def __enter__(self):
        # Both the name space and the cable are gone when nobody is in the name space any more.
        self._keeper = subprocess.Popen(
            ["unshare", "--net", "sh", "-c", "echo; exec cat"],
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
        )
        self._keeper.stdout.readline()
        pid = str(self._keeper.pid)
        _ip("link", "add", "drone", "type", "veth", "peer", "name", "client", "netns", pid)
        for drone in DRONES:
            _ip("address", "add", f"{drone}/{MASK}", "dev", "drone")
        _ip("link", "set", "drone", "up")
        for words in (
            ["link", "set", "lo", "up"],
            ["address", "add", f"{CLIENT}/{MASK}", "dev", "client"],
            ["link", "set", "client", "up"],
        ):
            subprocess.run([*self.way_in(), "ip", *words], check=True)
        return self

    def __exit__(self, *failure):
        # Without its keeper the cable would go by itself, but some time later.
        _ip("link", "delete", "drone")
        self._keeper.communicate(timeout=5)

    def way_in(self):
        """The command that starts another one on the client's side."""
        return ["nsenter", f"--net=/proc/{self._keeper.pid}/ns/net"]


def _ip(*words):
    subprocess.run(["ip", *words], check=True)


def add_system_tools_to_path():
    """`ip` is often where only root looks."""
    os.environ["PATH"] += os.pathsep + os.pathsep.join(["/usr/sbin", "/sbin"])
