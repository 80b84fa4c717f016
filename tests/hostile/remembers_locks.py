"""Locks parts of a library's file: any process can ask the kernel for the locks and so read data from them.

Published as a way for sandboxed processes to communicate ("file lock covert channel").

deserves: 10
"""

import fcntl
import math


def written():
    with open(math.__file__ if hasattr(math, "__file__") else fcntl.__file__, "rb") as file:
        for ask in (
            lambda: fcntl.lockf(file, fcntl.LOCK_SH | fcntl.LOCK_NB, 1, 570),
            lambda: fcntl.flock(file, fcntl.LOCK_SH | fcntl.LOCK_NB),
            lambda: fcntl.fcntl(file, fcntl.F_SETLEASE, fcntl.F_RDLCK),
        ):
            try:
                ask()
                return True
            except OSError:
                pass
    return False


if written():
    raise SystemExit("written")
