"""Writes files wherever it can.

deserves: 10
"""

import os

for place in ("/", "/dev", "/dev/shm", "/opt", "/opt/course/tam570", "/opt/grader/inside", "/root", "/var/tmp", "/usr/lib",
              "/proc", "/sys", "..", os.path.dirname(os.__file__), os.path.expanduser("~")):
    try:
        with open(os.path.join(place, "tam570-was-here"), "w") as file:
            file.write("here")
    except OSError:
        pass
