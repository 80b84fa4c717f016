"""Opens a terminal of its own and writes: times change, and numbers are taken, where the next submission looks.

A device's times move when it is written to, on a read-only mount too.

deserves: 10
"""

import os

for place in ("/dev/pts/ptmx", "/dev/ptmx", "/dev/tty", "/dev/console"):
    try:
        terminal = os.open(place, os.O_RDWR | os.O_NOCTTY)
        os.write(terminal, b"note")
    except OSError:
        continue
    raise SystemExit(f"written to {place}")
if os.path.isdir("/dev/pts") and os.listdir("/dev/pts"):
    raise SystemExit("there are terminals")
