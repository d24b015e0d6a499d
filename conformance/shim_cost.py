#!/usr/bin/env python3
"""Measures the time that the shim adds to a datagram, and fails above a limit. Run it with:

java -jar target/tello-simulator.jar run --shim --headless -- python3 conformance/shim_cost.py
"""

import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile

MOST_MS = 0.2
PAIRS = 5

PYTHON = """
import socket, statistics, sys, time
drone = sys.argv[1], int(sys.argv[2])
operator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
def ask(text):
    started = time.perf_counter()
    operator.sendto(text, drone)
    operator.recvfrom(100)
    return 1000 * (time.perf_counter() - started)
ask(b"command")
print(statistics.median([ask(b"battery?") for _ in range(2000)]))
"""

NODE = """
const [host, port] = process.argv.slice(-2);
const operator = require('dgram').createSocket('udp4');
const times = [];
let started;
const ask = (text) => {
  started = process.hrtime.bigint();
  operator.send(text, Number(port), host);
};
operator.on('message', () => {
  times.push(Number(process.hrtime.bigint() - started) / 1e6);
  if (times.length < 2000) {
    ask('battery?');
  } else {
    operator.close();
    console.log(times.sort((a, b) => a - b)[1000]);
  }
});
ask('command');
"""

JAVA = """
import java.net.*;
import java.util.Arrays;

public class Operator {
  public static void main(String[] words) throws Exception {
    SocketAddress drone = new InetSocketAddress(words[0], Integer.parseInt(words[1]));
    double[] times = new double[10_000];
    try (DatagramSocket operator = new DatagramSocket()) {
      for (int i = 0; i < times.length; i++) {
        byte[] text = (i == 0 ? "command" : "battery?").getBytes();
        long started = System.nanoTime();
        operator.send(new DatagramPacket(text, text.length, drone));
        operator.receive(new DatagramPacket(new byte[100], 100));
        times[i] = (System.nanoTime() - started) / 1e6;
      }
    }
    Arrays.sort(times);
    System.out.println(times[times.length / 2]);
  }
}
"""

REAL = ["192.168.10.1", "8889"]
SHIMS = ("PYTHONPATH", "NODE_OPTIONS", "JAVA_TOOL_OPTIONS")


def asked(command, environment):
    done = subprocess.run(command, env=environment, stdout=subprocess.PIPE, check=True, text=True)
    return float(done.stdout)


def cost(command):
    """The median time that the shim adds to a round trip, halved: for one of its two datagrams."""
    without = {name: value for name, value in os.environ.items() if name not in SHIMS}
    simulated = [os.environ["TELLO_HOST"], os.environ["TELLO_PORT"]]
    pairs = [
        (asked([*command, *REAL], os.environ), asked([*command, *simulated], without))
        for _ in range(PAIRS)
    ]
    return statistics.median(shimmed - plain for shimmed, plain in pairs) / 2


def main():
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        program = pathlib.Path(folder, "Operator.java")
        program.write_text(JAVA)
        for name, command in {
            "Python": [sys.executable, "-c", PYTHON],
            "Node.js": ["node", "-e", NODE, "--"],
            "Java": ["java", str(program)],
        }.items():
            if shutil.which(command[0]):
                added = cost(command)
                failed |= added > MOST_MS
                print(f"the shim adds {added:.3f} ms to a datagram of {name} (at most {MOST_MS})")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
