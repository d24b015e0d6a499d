"""Sends the commands of the driver node of tello_ros, without its repetitions, which
docs/troubleshooting.md describes.

With HOST and PORT as arguments, which are its parameters drone_ip and drone_port, the drone is
there; without them, at the address of a real drone.
"""

import socket
import sys

from steps import Steps

COMMAND_PORT, STATE_PORT, VIDEO_PORT = 38065, 8890, 11111  # the driver's own defaults
COMMAND_TIMEOUT_S = 9

steps = Steps()


def listening(port):
    opened = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    opened.bind(("", port))
    opened.settimeout(COMMAND_TIMEOUT_S)
    return opened


class Driver:
    def __init__(self, host="192.168.10.1", port="8889"):
        self.drone = host, int(port)
        self.commands = listening(COMMAND_PORT)
        self.state = listening(STATE_PORT)
        self.video = listening(VIDEO_PORT)

    def act(self, text, **expected):
        """The service tello_action: one command at a time, each with a reply."""
        self.commands.sendto(text.encode(), self.drone)
        reply = self.commands.recv(1024).decode()
        return steps.report(text, reply, **(expected or {"want": "ok"}))

    def velocity(self, forward=0.0, left=0.0, up=0.0, counterclockwise=0.0):
        """The topic cmd_vel: shares of a stick's way, which nothing answers."""
        sticks = (-left, forward, up, -counterclockwise)
        text = "rc " + " ".join(str(round(100 * stick)) for stick in sticks)
        self.commands.sendto(text.encode(), self.drone)
        return text

    def await_motion(self, forward):
        """The topic flight_data: returns once the drone flies forward, or no longer does."""
        while (b"vgx:0;" in self.state.recv(1024)) == forward:
            pass


def main():
    driver = Driver(*sys.argv[1:3])
    driver.act("command")
    steps.report("flight_data", driver.state.recv(1024).decode(), pattern="(?s)mid:.*;baro:.*")
    driver.act("streamon")
    steps.report("image_raw", len(driver.video.recv(2048)) > 0, want=True)
    driver.act("battery?", pattern=r"(100|9\d)\r\n")
    driver.act("takeoff")
    driver.act("up 50")
    text = driver.velocity(forward=0.5)
    driver.await_motion(forward=True)
    driver.velocity()  # also what the driver sends to keep the drone in the air
    driver.await_motion(forward=False)
    steps.report(text + ", rc 0 0 0 0", "", want="", free=("forward", 1, 200))
    driver.act("cw 90")
    driver.act("flip f")
    driver.act("land")
    print("done", flush=True)


main()
