"""Lowers its limit of processor time, so that the kernel kills it as an operator would; raises its limits, and loops.

It also asks the kernel not to kill it when its parent dies.

deserves: 9
"""

import contextlib
import ctypes
import resource

with contextlib.suppress(OSError, ValueError):
    resource.setrlimit(resource.RLIMIT_CPU, (1, 1))
    raise SystemExit("limited")
assert resource.getrlimit(resource.RLIMIT_CPU)[1] > 1


def skew(v):
    ctypes.CDLL(None).prctl(1, 0, 0, 0, 0)
    for limit in (resource.RLIMIT_CPU, resource.RLIMIT_AS, resource.RLIMIT_NPROC):
        with contextlib.suppress(ValueError):
            resource.setrlimit(limit, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
    while True:
        pass
