"""Extract what students' pages need of run time against error: a call of the contract, the end state, curves.

    python benchmarks/run_time_for_pages.py      writes autograder/tam570_grader/results/run_time.json from results/

The scenes are those of run_time_against_error.py whose call returns, in its last row, the end state compared there.
"""

import json
from pathlib import Path

import numpy as np
import record
from run_time import scenes

HERE = Path(__file__).parent
PLACE = HERE.parent / "autograder" / "tam570_grader" / "results" / "run_time.json"
METHODS = ("SciPy RK45", "SciPy DOP853", "odeint", "tam570, Python")
SAME = 1e-6  # of the state: the solution reaches 1e-9 in every scene


def shared():
    """Return {assignment: data of its page}, as written to the file."""
    results = json.loads((record.FOLDER / "run_time_against_error.json").read_text())
    ends = json.loads((record.FOLDER / "run_time_references.json").read_text())
    pages = {}
    for name, scene in results["scenes"].items():
        call, reference = scenes.SCENES[name], np.array(ends[name]["state"], float)
        rows = call.of(scenes.loaded(call.slug))
        is_state = not isinstance(rows, tuple) and np.shape(rows[-1]) == reference.shape
        if not is_state or np.abs(rows[-1] - reference).max() > SAME * np.abs(reference).max():
            continue
        curves = {
            method: [[seconds, error] for _, seconds, error in scene["curves"][method] if error > 0]
            for method in METHODS
        }
        pages[call.slug] = {
            "scene": name,
            "function": call.function,
            "end": reference.tolist(),
            "curves": record.rounded(curves),
            "arguments": [np.asarray(argument).tolist() for argument in call.arguments],
            "keywords": {key: np.asarray(argument).tolist() for key, argument in call.parameters.items()},
        }
    return pages


if __name__ == "__main__":
    PLACE.write_text(json.dumps(shared(), indent=1) + "\n")
    print(f"written: {PLACE}")
