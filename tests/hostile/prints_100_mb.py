"""Prints 100 MB, in Python and below it.

deserves: 10
"""

import os
import sys

line = "x" * 10**6
for _ in range(50):
    print(line)
    print(line, file=sys.stderr)
for file in (1, 2):
    os.write(file, line.encode())
