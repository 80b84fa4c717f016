"""Tries to import the grader, the checks and the solution by every name that they might have.

Published against graders in Moodle (Kratzke, "Smart Like a Fox", CSEDU 2019: redirection to the reference
solution).

deserves: 10
"""

import importlib

for name in ("tam570_grader", "tam570_grader.writing.check", "solutions", "checks", "_checks_hw08_axis_angle",
             "_solution_hw08_axis_angle", "autograder", "conftest"):
    try:
        importlib.import_module(name)
    except ImportError:
        continue
    raise SystemExit(f"imported {name}")
