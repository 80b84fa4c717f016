"""The programs of `benchmarks` import without an error."""

import subprocess
import sys
from pathlib import Path

PROGRAMS = Path(__file__).parents[1] / "benchmarks"
IMPORT_ALL = "import runpy, sys; sys.path[:0] = sys.argv[1:2]; [runpy.run_path(path) for path in sys.argv[2:]]"


def test_every_program_imports():
    programs = map(str, sorted(PROGRAMS.glob("*.py")))
    done = subprocess.run([sys.executable, "-c", IMPORT_ALL, PROGRAMS, *programs], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
