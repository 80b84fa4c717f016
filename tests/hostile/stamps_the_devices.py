"""Writes to devices and terminals, and changes their timestamps, which every submission can read.

A write to a device changes its timestamps even on a read-only mount.

deserves: 10
"""

import contextlib
import os

for folder in ("/dev", "/dev/pts"):
    for name in os.listdir(folder):
        with contextlib.suppress(OSError):
            os.utime(os.path.join(folder, name))  # sets the time to now: the moment of the call carries the data
            raise SystemExit("written")
for place in ("/dev/pts/ptmx", "/dev/ptmx", "/dev/tty", "/dev/console"):
    with contextlib.suppress(OSError):
        os.write(os.open(place, os.O_RDWR | os.O_NOCTTY), b"note")
        raise SystemExit(f"written to {place}")
if os.path.isdir("/dev/pts") and os.listdir("/dev/pts"):
    raise SystemExit("there are terminals")
with open(os.devnull, "w") as nowhere:
    nowhere.write("as ever")
