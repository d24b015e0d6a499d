# Cuts the first corner, and meets the pillar if there is one.
import socket

drone = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
drone.bind(("", 9000))
drone.settimeout(30)


def ask(command):
    drone.sendto(command.encode(), ("192.168.10.1", 8889))
    reply = drone.recv(1024).decode()
    print(command, "->", reply)
    return reply


for command in ["command", "takeoff", "go 200 200 0 60", "back 200", "right 200", "land"]:
    ask(command)
