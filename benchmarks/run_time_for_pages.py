"""What the students' pages need of run time against error: a call of the contract, the end state, curves.

    python benchmarks/run_time_for_pages.py      writes autograder/tam570_grader/results/run_time.json from results/

The scenes are those of run_time_against_error.py; one is kept where the call's last row is the state compared there.
"""

import json
import sys
from pathlib import Path

import numpy as np

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE / "run_time"))

import scenes  # noqa: E402

PLACE = HERE.parent / "autograder" / "tam570_grader" / "results" / "run_time.json"
METHODS = ("SciPy RK45", "SciPy DOP853", "odeint", "tam570, Python")
SAME = 1e-6  # of the state: the solution reaches 1e-9 in every scene


def call(name):
    """(assignment, function, arguments, keywords) that a scene hands to a solution."""
    calls, original = [], scenes._handed_over

    def noted(slug, function, *arguments, **given):
        calls.append((slug, function, arguments, given))
        return original(slug, function, *arguments, **given)

    scenes._handed_over = noted
    try:
        scenes.scene(name)
    finally:
        scenes._handed_over = original
    return calls[-1]


def end_row(slug, function, arguments, given):
    """The last row of the solution's result, None if it is not an array of rows."""
    found = getattr(scenes._loaded(scenes.SOLUTIONS / f"{slug}.py"), function)(*arguments, **given)
    return None if isinstance(found, tuple) else np.asarray(found)[-1]


def shared():
    """{assignment: what its page needs}, as it is written."""
    results = json.loads((HERE / "results" / "run_time_against_error.json").read_text())
    ends = json.loads((HERE / "results" / "run_time_references.json").read_text())
    found = {}
    for name, scene in results["scenes"].items():
        slug, function, arguments, given = call(name)
        row, right = end_row(slug, function, arguments, given), np.array(ends[name]["state"], float)
        if row is None or row.shape != right.shape or np.abs(row - right).max() > SAME * np.abs(right).max():
            continue
        curves = {
            method: [[_short(seconds), _short(error)] for _, seconds, error in scene["curves"][method] if error > 0]
            for method in METHODS
        }
        found[slug] = {
            "scene": name,
            "function": function,
            "end": right.tolist(),
            "curves": curves,
            "arguments": [np.asarray(one).tolist() for one in arguments],
            "keywords": {key: np.asarray(one).tolist() for key, one in given.items()},
        }
    return found


def _short(number):
    return float(f"{number:.3g}")


if __name__ == "__main__":
    PLACE.write_text(json.dumps(shared(), indent=1) + "\n")
    print(f"written: {PLACE}")
