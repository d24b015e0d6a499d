"""Takes off and lands: python3 fly.py HOST PORT"""

import socket
import sys

drone = (sys.argv[1], int(sys.argv[2]))
operator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
operator.settimeout(10)
for command in ["command", "takeoff", "land"]:
    operator.sendto(command.encode(), drone)
    print(command, operator.recv(1024).decode())
