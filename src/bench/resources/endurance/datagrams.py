"""Datagrams that a Java program cannot send or see: with a forged sender, and those of others.

datagrams.py forge SENDER SENDER_PORT DRONE DRONE_PORT TEXT...
    sends each text as if it came from SENDER, and prints `forged BYTES`
datagrams.py witness DRONE PORT...
    takes what comes to the ports, silently; after each line typed prints `seen BYTES AGE`: how much
    UDP has come from DRONE, to whatever port and address, and how many seconds ago the last

Bytes are those of whole IP packets.
"""

import select
import socket
import struct
import sys
import time

ETHERNET_IP = 0x0800
IP_HEADER = struct.Struct("!BBHHHBBH4s4s")
UDP_HEADER = struct.Struct("!HHHH")
UDP = socket.IPPROTO_UDP


def forge(sender, sender_port, drone, drone_port, *texts):
    link = socket.socket(socket.AF_INET, socket.SOCK_RAW, socket.IPPROTO_RAW)
    total = 0
    for text in texts:
        payload = text.encode("latin-1")
        size = UDP_HEADER.size + len(payload)
        udp = UDP_HEADER.pack(int(sender_port), int(drone_port), size, 0) + payload
        ends = socket.inet_aton(sender), socket.inet_aton(drone)
        # The kernel fills in total length, identification and checksum.
        packet = IP_HEADER.pack(0x45, 0, 0, 0, 0, 64, UDP, 0, *ends) + udp
        link.sendto(packet, (drone, 0))
        total += len(packet)
    print("forged", total)


def witness(drone, *ports):
    silent = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in ports]
    for taker, port in zip(silent, ports):
        taker.bind(("", int(port)))
    wire = socket.socket(socket.AF_PACKET, socket.SOCK_DGRAM, socket.htons(ETHERNET_IP))
    wire.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 1 << 22)
    address = socket.inet_aton(drone)
    seen, last = 0, time.monotonic()
    print("watching")
    while True:
        ready, _, _ = select.select([wire, sys.stdin], [], [])
        if wire in ready:
            packet = wire.recv(65536)
            fields = IP_HEADER.unpack_from(packet)
            if fields[6] == UDP and fields[8] == address:
                seen += fields[2]
                last = time.monotonic()
        elif sys.stdin.readline():
            print("seen", seen, f"{time.monotonic() - last:.3f}")
        else:
            return


if __name__ == "__main__":
    {"forge": forge, "witness": witness}[sys.argv[1]](*sys.argv[2:])
