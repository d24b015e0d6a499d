# Asks for more than the drone can do, and forgets to land.
import socket

drone = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
drone.bind(("", 9000))
drone.settimeout(30)


def ask(command):
    drone.sendto(command.encode(), ("192.168.10.1", 8889))
    reply = drone.recv(1024).decode()
    print(command, "->", reply)
    return reply


for command in ["command", "takeoff", "forward 2000", "forward 200", "left 200", "back 200", "right 200"]:
    ask(command)
