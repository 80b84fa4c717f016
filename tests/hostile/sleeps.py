"""Sleeps in one function.

deserves: 9
"""

import time


def skew(v):
    time.sleep(10**6)
