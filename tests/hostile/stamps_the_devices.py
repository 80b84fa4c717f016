"""Writes into the times of the system's devices, which every submission can read.

deserves: 10
"""

import os


def written():
    for folder in ("/dev", "/dev/pts"):
        for name in os.listdir(folder):
            try:
                os.utime(os.path.join(folder, name))  # now: what is written is when
            except OSError:
                continue
            return True
    return False


if written():
    raise SystemExit("written")
with open(os.devnull, "w") as nowhere:
    nowhere.write("as ever")
