"""Waits until a simulator that has just been started films at full pace.

While Java still compiles what filming takes, the first seconds have fewer pictures. How long they
take is measured elsewhere; here they would only make clients give up on a busy machine.
"""

import collections
import contextlib
import socket
import time

VIDEO_PORT = 11111
PICTURES_A_SECOND = 28
PATIENCE_S = 15
PICTURES = (1, 5)  # kinds of NAL units


def await_full_pace(host, port):
    """Asks for the video, and looks at it; the drone is filming afterwards, and the port is free."""
    with contextlib.ExitStack() as stack:
        commands, video = (
            stack.enter_context(socket.socket(socket.AF_INET, socket.SOCK_DGRAM)) for _ in range(2)
        )
        video.bind(("", VIDEO_PORT))
        video.settimeout(PATIENCE_S)
        commands.settimeout(PATIENCE_S)
        for text in b"command", b"streamon":
            commands.sendto(text, (host, port))
            commands.recv(1024)
        _await_pictures(video)


def _await_pictures(video):
    times = collections.deque()
    patience = time.monotonic() + PATIENCE_S
    while len(times) < PICTURES_A_SECOND and time.monotonic() < patience:
        datagram = video.recv(2048)
        now = time.monotonic()
        if datagram[:4] == b"\0\0\0\1" and datagram[4] & 31 in PICTURES:
            times.append(now)
        while times and now - times[0] > 1:
            times.popleft()
