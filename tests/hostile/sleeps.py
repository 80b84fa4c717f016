"""Sleeps for 10^6 s in one function.

deserves: 9
"""

import time


def skew(v):
    time.sleep(10**6)
