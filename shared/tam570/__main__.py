"""The students' command; `python -m tam570` imports no module, such as random.py, from the current folder."""

import sys

if __name__ == "__main__":
    sys.path[:] = sys.path[1:]  # the current folder, which `-m` puts first

from tam570.signals import end_at_once  # noqa: E402

end_at_once()  # the imports take time

from tam570.cli import main  # noqa: E402

if __name__ == "__main__":
    sys.exit(main())
