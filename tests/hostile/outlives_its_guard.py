"""Asks not to die with its parent, and raises its own limits, then loops.

deserves: 9
"""

import ctypes
import resource


def skew(v):
    ctypes.CDLL(None).prctl(1, 0, 0, 0, 0)
    for limit in (resource.RLIMIT_CPU, resource.RLIMIT_AS, resource.RLIMIT_NPROC):
        try:
            resource.setrlimit(limit, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
        except ValueError:
            pass
    while True:
        pass
