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

    def noted(slug, function, *arguments, **keywords):
        calls.append((slug, function, arguments, keywords))
        return original(slug, function, *arguments, **keywords)

    scenes._handed_over = noted
    try:
        scenes.scene(name)
    finally:
        scenes._handed_over = original
    return calls[-1]


def end_row(slug, function, arguments, keywords):
    """The last row of the solution's result, None if it is not an array of rows."""
    rows = getattr(scenes._loaded(scenes.SOLUTIONS / f"{slug}.py"), function)(*arguments, **keywords)
    return None if isinstance(rows, tuple) else np.asarray(rows)[-1]


def shared():
    """{assignment: what its page needs}, as it is written."""
    results = json.loads((HERE / "results" / "run_time_against_error.json").read_text())
    ends = json.loads((HERE / "results" / "run_time_references.json").read_text())
    pages = {}
    for name, scene in results["scenes"].items():
        slug, function, arguments, keywords = call(name)
        row, reference = end_row(slug, function, arguments, keywords), np.array(ends[name]["state"], float)
        if (
            row is None
            or row.shape != reference.shape
            or np.abs(row - reference).max() > SAME * np.abs(reference).max()
        ):
            continue
        curves = {
            method: [[_short(seconds), _short(error)] for _, seconds, error in scene["curves"][method] if error > 0]
            for method in METHODS
        }
        pages[slug] = {
            "scene": name,
            "function": function,
            "end": reference.tolist(),
            "curves": curves,
            "arguments": [np.asarray(argument).tolist() for argument in arguments],
            "keywords": {key: np.asarray(argument).tolist() for key, argument in keywords.items()},
        }
    return pages


def _short(number):
    return float(f"{number:.3g}")


if __name__ == "__main__":
    PLACE.write_text(json.dumps(shared(), indent=1) + "\n")
    print(f"written: {PLACE}")
