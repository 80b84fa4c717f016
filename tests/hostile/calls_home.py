"""Opens network connections.

Published against Jobe (trampgeek/jobe issue 87: notes fetched in an exam), Artemis (ls1intum/Ares issue 376)
and nbgrader (pull request 1324: code is fetched).

deserves: 10
"""

import socket

for family, address in (
    (socket.AF_INET, ("127.0.0.1", 22)),
    (socket.AF_INET, ("10.0.0.1", 80)),
    (socket.AF_UNIX, "/var/run/docker.sock"),
    (socket.AF_UNIX, "\0tam570"),
):
    try:
        with socket.socket(family, socket.SOCK_STREAM) as client:
            client.settimeout(0.2)
            client.connect(address)
            raise SystemExit("connected")
    except OSError:
        pass
