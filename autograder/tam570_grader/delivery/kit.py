"""Makes the students' kit: the wheel of the course and a page that says how to start."""

import sys
from pathlib import Path

from tam570_grader.errors import UsageError, writing
from tam570_grader.results.journal import written

__all__ = ["run"]

README = """# Your kit for Intermediate Dynamics

You need Python 3.11 or newer. In this folder:

    python3 -m venv dynamics           # on Windows: python -m venv dynamics
    . dynamics/bin/activate            # on Windows: dynamics\\Scripts\\activate
    pip install {wheel}

Then, wherever you want to work:

    tam570 list                        # the assignments
    tam570 start hw08                  # makes a folder with the problem, the file to fill in, and tests
    tam570 check hw08                  # runs the tests on what you have written so far
    tam570 check hw08 --watch          # runs those that a change concerns, each time you save
    tam570 hint hw08 rotation_matrix   # a first hint; ask again for the next one
    tam570 show hw08                   # your own functions, as a scene that moves

Fill in the functions of `hw08_axis_angle.py`; everything asked for is in the README beside it. Hand in that
one file. It will be tested with other numbers than yours.
"""


def run(course: Path, folder: Path) -> int:
    """Put the kit into the folder; the exit code."""
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
    wheel = _wheel(course, folder.resolve())
    written(folder / "README.md", README.format(wheel=wheel.name))
    print(f"{folder}: {wheel.name} and README.md, for your students", file=sys.stderr)
    return 0


def _wheel(course: Path, folder: Path) -> Path:
    """Build the wheel, which holds no solution and no check."""
    try:
        from hatchling.builders.wheel import WheelBuilder
    except ImportError:
        raise UsageError("building the wheel needs hatchling: pip install 'tam570[grader]'") from None
    for old in folder.glob("tam570-*.whl"):
        old.unlink()
    return Path(next(iter(WheelBuilder(str(course)).build(directory=str(folder), versions=["standard"]))))
