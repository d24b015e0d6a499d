"""The shim for Python, which the interpreter loads before the program: sockets, and with them asyncio,
find simulated drones at the addresses of real ones."""

import os
import socket
import sys

_PROGRAM = "192.168.10.2"  # the address of a machine that has joined the drone's network


def _address(text):
    host, port = text.split(":")
    return host, int(port)


_PAIRS = [
    tuple(map(_address, pair.split("=")))
    for pair in os.environ.get("TELLO_SIMULATOR_SHIM", "").split(",")
    if pair
]
_SIMULATED = dict(_PAIRS)
_REAL = {simulator: drone for drone, simulator in _PAIRS}


def _simulated(address):
    try:
        return _SIMULATED.get(address, address)
    except TypeError:  # not hashable: the system's method reports the error
        return address


def _real(address):
    return _REAL.get(address, address)


def _is_datagram(sock):
    return sock.family == socket.AF_INET and sock.type == socket.SOCK_DGRAM


def _shim_sockets():
    """Changes the methods of the class itself, so that subclasses and other names of it follow."""
    kind = socket.socket
    old = {
        name: getattr(kind, name, None)
        for name in (
            "bind connect connect_ex getpeername"
            " recvfrom recvfrom_into recvmsg recvmsg_into sendmsg sendto"
        ).split()
    }

    def bind(self, address):
        if _is_datagram(self) and isinstance(address, tuple) and address[:1] == (_PROGRAM,):
            address = ("", *address[1:])
        return old["bind"](self, address)

    def connect(self, address):
        return old["connect"](self, _simulated(address) if _is_datagram(self) else address)

    def connect_ex(self, address):
        return old["connect_ex"](self, _simulated(address) if _is_datagram(self) else address)

    def getpeername(self):
        peer = old["getpeername"](self)
        return _real(peer) if _is_datagram(self) else peer

    def recvfrom(self, *arguments):
        data, sender = old["recvfrom"](self, *arguments)
        return data, _real(sender)

    def recvfrom_into(self, *arguments, **named):
        count, sender = old["recvfrom_into"](self, *arguments, **named)
        return count, _real(sender)

    def sendto(self, *arguments):
        if len(arguments) > 1:
            arguments = (*arguments[:-1], _simulated(arguments[-1]))
        return old["sendto"](self, *arguments)

    def recvmsg(self, *arguments):
        *received, sender = old["recvmsg"](self, *arguments)
        return (*received, _real(sender))

    def recvmsg_into(self, *arguments):
        *received, sender = old["recvmsg_into"](self, *arguments)
        return (*received, _real(sender))

    def sendmsg(self, *arguments):
        if len(arguments) == 4:
            arguments = (*arguments[:3], _simulated(arguments[3]))
        return old["sendmsg"](self, *arguments)

    new = locals()
    for name, method in old.items():
        if method is not None:
            setattr(kind, name, new[name])


def _shim_proactor():
    """asyncio on Windows calls the system without the methods of sockets."""
    from asyncio import windows_events
    from asyncio.proactor_events import _ProactorDatagramTransport

    proactor = windows_events.IocpProactor
    old_connect, old_sendto = proactor.connect, proactor.sendto
    old_init = _ProactorDatagramTransport.__init__

    def connect(self, conn, address):
        return old_connect(self, conn, _simulated(address) if _is_datagram(conn) else address)

    def sendto(self, conn, buf, flags=0, addr=None):
        return old_sendto(self, conn, buf, flags, _simulated(addr))

    class Receiver:
        """A protocol that passes everything on, and datagrams with the addresses of real drones."""

        def __init__(self, protocol):
            self._protocol = protocol

        def __getattr__(self, name):
            return getattr(self._protocol, name)

        def datagram_received(self, data, address):
            self._protocol.datagram_received(data, _real(address))

    def init(self, loop, sock, protocol, *arguments, **named):
        old_init(self, loop, sock, Receiver(protocol), *arguments, **named)

    proactor.connect, proactor.sendto = connect, sendto
    _ProactorDatagramTransport.__init__ = init


class _ProactorImport:
    """An import hook that patches asyncio when the program first imports it. Importing it here would
    delay every start."""

    def find_spec(self, name, path=None, target=None):
        if name == "asyncio.windows_events":
            sys.meta_path.remove(self)
            import importlib.util

            spec = importlib.util.find_spec(name)
            loader = spec.loader
            execute = loader.exec_module

            def exec_module(module):
                execute(module)
                _shim_proactor()

            loader.exec_module = exec_module
            return spec
        return None


def _load_hidden_customization():
    """Loads the sitecustomize of the system, which this file hides."""
    import importlib.machinery
    import importlib.util

    here = os.path.dirname(os.path.abspath(__file__))
    folders = [folder for folder in sys.path if os.path.abspath(folder or ".") != here]
    spec = importlib.machinery.PathFinder.find_spec("sitecustomize", folders)
    if spec and spec.loader:
        spec.loader.exec_module(importlib.util.module_from_spec(spec))


if _PAIRS:
    _shim_sockets()
    if sys.platform == "win32":
        sys.meta_path.insert(0, _ProactorImport())
_load_hidden_customization()
