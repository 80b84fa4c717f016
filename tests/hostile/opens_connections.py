"""Connects to the network and to services of the machine, binds ports, and names a socket of a pair for its neighbours.

A port stays in use for a minute after a connection. In a network that submissions share, used ports would carry data
from one submission to the next, and from a call to the next import of the file, whose error the student reads.
Published against Jobe (trampgeek/jobe issue 87: notes fetched in an exam), Artemis (ls1intum/Ares issue 376) and
nbgrader (pull request 1324: code is downloaded).

deserves: 10
"""

import contextlib
import socket

PORTS = 22, 53, 80, 443, 631, 4000, 5432, 6379, 8000, 8080, 8888
NAMES = "\0tam570", "\0/tmp/.X11-unix/X0", "\0/tmp/dbus", "/run/dbus/system_bus_socket", "/var/run/docker.sock"
NAMES += ("/run/systemd/private",)
SERVERS = [(socket.AF_INET, (host, port)) for host in ("127.0.0.1", "10.0.0.1") for port in PORTS]
SERVERS += [(socket.AF_UNIX, name) for name in NAMES]
OURS = {socket.AF_INET: ("", 30_000), socket.AF_INET6: ("", 30_000), socket.AF_UNIX: "\0tam570-was-here"}
for family, address in SERVERS:
    with contextlib.suppress(OSError), socket.socket(family, socket.SOCK_STREAM) as client:
        client.settimeout(0.05)
        client.connect(address)
        raise SystemExit("connected")
for family, address in OURS.items():
    with contextlib.suppress(OSError), socket.socket(family, socket.SOCK_STREAM) as server:
        server.bind(address)
        server.listen()
        raise SystemExit("written")
ours, _ = socket.socketpair(socket.AF_UNIX, socket.SOCK_DGRAM)
HERE = OURS[socket.AF_UNIX]
for attempt in (
    lambda: ours.connect(HERE),
    lambda: ours.bind(HERE),
    lambda: ours.setsockopt(socket.SOL_SOCKET, socket.SO_PASSCRED, 1),
    lambda: ours.sendto(b"x", HERE),
    lambda: ours.sendmsg([b"x"], [], 0, HERE),
):
    with contextlib.suppress(PermissionError):
        attempt()
        raise SystemExit("named")
