"""The benchmarks: their programs import what exists, and each result says how it was measured."""

import json
import subprocess
import sys
from pathlib import Path

import pytest

PROGRAMS = Path(__file__).parents[1] / "benchmarks"
RESULTS = PROGRAMS / "results"
TABLES = [path for path in sorted(RESULTS.glob("*.json")) if path.stem != "run_time_references"]
IMPORT_ALL = "import runpy, sys; sys.path[:0] = sys.argv[1:2]; [runpy.run_path(path) for path in sys.argv[2:]]"


def test_every_program_imports():
    programs = map(str, sorted(PROGRAMS.glob("*.py")))
    done = subprocess.run([sys.executable, "-c", IMPORT_ALL, PROGRAMS, *programs], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr


@pytest.mark.parametrize("path", TABLES, ids=lambda path: path.stem)
def test_a_result_names_its_machine_date_and_program(path):
    results = json.loads(path.read_text())
    python, program, *_ = results["command"].split()
    assert python == "python" and (PROGRAMS.parent / program).is_file()
    assert results["machine"] and len(results["date"].split("-")) == 3


def test_the_results_stay_small():
    assert sum(path.stat().st_size for path in RESULTS.iterdir()) < 300_000
