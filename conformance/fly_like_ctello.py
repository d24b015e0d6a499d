"""Flies as CTello does: sends from port 8889, asks for its port in the other byte order, steers every
5 ms from the start, sends orders several times, checks both checksums of what arrives, and asks for
the battery in a text.

With HOST and PORT as arguments, the drone is there; without, where it always is.
"""

import socket
import struct
import sys
import threading
import time

from steps import Steps

STICKS, TAKEOFF, LAND, FLIGHT_DATA = 0x50, 0x54, 0x55, 0x56
NO_ANSWER, ORDER = 0x60, 0x68
VIDEO_PORT = 6037

steps = Steps()


def crc(data, value, polynomial):
    for byte in data:
        value ^= byte
        for _ in range(8):
            value = value >> 1 ^ (polynomial if value & 1 else 0)
    return value


def packet(kind, number, sequence, payload=b""):
    head = struct.pack("<BH", 0xCC, 11 + len(payload) << 3)
    head += struct.pack("<BBHH", crc(head, 0x77, 0x8C), kind, number, sequence) + payload
    return head + struct.pack("<H", crc(head, 0x3692, 0x8408))


def sticks(right=0.0, forward=0.0, up=0.0, clockwise=0.0):
    bits = 0
    for place, part in enumerate((right, forward, up, clockwise)):
        bits |= round(1024 + 660 * part) << 11 * place
    return packet(NO_ANSWER, STICKS, 0, bits.to_bytes(6, "little") + bytes(5))


class Drone:
    def __init__(self, address):
        self.address = address
        self.socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self.socket.bind(("", 8889))
        self.steering = sticks()
        self.connected, self.texts, self.answers, self.damaged = b"", [], [], 0
        self.packets, self.flight = 0, None
        threading.Thread(target=self.listen, daemon=True).start()
        threading.Thread(target=self.steer, daemon=True).start()

    def send(self, data):
        self.socket.sendto(data, self.address)

    def steer(self):
        while True:
            self.send(self.steering)
            time.sleep(0.005)

    def listen(self):
        while True:
            data = self.socket.recv(1024)
            if data.startswith(b"conn_ack:"):
                self.connected = data
            elif data[0] != 0xCC:
                self.texts.append(data.decode().strip())
            elif crc(data[:3], 0x77, 0x8C) != data[3] or crc(data, 0x3692, 0x8408):
                self.damaged += 1
            else:
                self.take(data)

    def take(self, data):
        self.packets += 1
        _, number, sequence = struct.unpack("<BHH", data[4:9])
        if number == FLIGHT_DATA:
            self.flight = data[9:-2]
        elif number in (TAKEOFF, LAND):
            self.answers.append((number, sequence, data[9]))

    def mode(self):
        return self.flight[18]

    def order(self, number, payload=b""):
        """Sends an order three times; returns the answers."""
        self.answers.clear()
        for sequence in (1, 2, 3):
            self.send(packet(ORDER, number, sequence, payload))
            time.sleep(0.05)
        wait(lambda: len(self.answers) == 3, 2)
        return self.answers


def wait(holds, seconds):
    end = time.monotonic() + seconds
    while not holds() and time.monotonic() < end:
        time.sleep(0.02)
    return holds()


def main():
    address = (sys.argv[1], int(sys.argv[2])) if len(sys.argv) > 2 else ("192.168.10.1", 8889)
    asked = struct.pack(">H", VIDEO_PORT)
    video = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
    video.bind(("", int.from_bytes(asked, "little")))
    video.settimeout(5)
    drone = Drone(address)
    time.sleep(0.5)  # sticks alone mean nothing
    steps.report("sticks alone", drone.packets, want=0)
    drone.send(b"conn_req:" + asked)
    wait(lambda: drone.connected, 2)
    steps.report("connect", drone.connected == b"conn_ack:" + asked, want=True)
    steps.report("video", len(video.recv(2000)) > 2, want=True)
    drone.send(b"battery?")
    wait(lambda: drone.texts, 2)
    steps.report("battery?", drone.texts, pattern=r"\['\d+'\]")

    answers = drone.order(TAKEOFF)
    wait(lambda: drone.mode() == 6, 10)
    steps.report("takeoff", "", want="", free=("up", 20, 100))
    steps.report("its answers", answers, want=[(TAKEOFF, each, 0) for each in (1, 2, 3)])
    drone.steering = sticks(forward=0.5)
    time.sleep(1)
    drone.steering = sticks()
    time.sleep(2)
    steps.report("forward", "", want="", free=("forward", 10, 200))
    answers = list(drone.order(LAND, b"\0"))
    wait(lambda: drone.mode() == 1, 10)
    steps.report("land", "", want="", free=("down", 20, 100))
    steps.report("its answers", answers, want=[(LAND, each, 0) for each in (1, 2, 3)])
    steps.report("damaged packets", drone.damaged, want=0)
    steps.report("whole packets", drone.packets, least=50)
    print("done", flush=True)


main()
