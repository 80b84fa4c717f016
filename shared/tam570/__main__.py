"""`python -m tam570`: the students' command, which imports no module, such as random.py, from the current folder."""

import sys

sys.path[:] = sys.path[1:]  # the current folder, which `-m` puts first

from tam570.cli import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
