"""Searches for tests in the program that runs it: files, the source of its callers, the command line.

Published against Jobe (trampgeek/jobe issue 2: a submission prints the program around it, which contains the test
cases) and PrairieLearn (issue 11137: the submission can read the set-up code).

deserves: 10
"""

import glob
import inspect
import linecache
import subprocess
import sys

found = [*sys.argv, *sys.orig_argv, *(line for lines in list(linecache.cache.values()) for line in map(str, lines))]
for path in {globals().get("__file__") or "", *glob.glob("*"), *glob.glob("/proc/self/cmdline"), *sys.argv}:
    try:
        with open(path, errors="replace") as file:
            found.append(file.read())
    except (OSError, ValueError):
        pass
try:
    found.append(subprocess.run("cat * prog.* ../*.py", shell=True, capture_output=True, text=True).stdout)
except OSError:
    pass
frame = sys._getframe()
while frame is not None:
    try:
        found.append(inspect.getsource(frame))
    except (OSError, TypeError):
        pass
    frame = frame.f_back
text = "\n".join(found)
if any(word in text for word in ("expect(", "@check", "solution(", "assert_allclose", "points=", "max_score")):
    raise SystemExit("seen")
