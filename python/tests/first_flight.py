"""The first flight with the package: starts a simulator and flies it with plain sockets."""

import socket

from tello_simulator import Simulator

with Simulator() as simulator, socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
    operator.settimeout(10)
    for command in ("command", "takeoff", "forward 100", "cw 90", "land"):
        operator.sendto(command.encode(), simulator.drone.address)
        print(command, operator.recv(1024).decode())
    x, y, _ = simulator.drone.truth().position
    print(f"landed at x {x:.0f} cm, y {y:.0f} cm")
