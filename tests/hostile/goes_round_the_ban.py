"""Imports forbidden modules by way of importlib and of allowed packages.

Published against PrairieLearn (PrairieLearn/PrairieLearn pull request 10822: forbidden imports can be
circumvented).

deserves: nothing
"""

import importlib
import sys


def skew(v):
    sys.modules.pop("tam570.rotations", None)
    return importlib.import_module("tam570.rotations").skew(v)


def rotation_matrix(axis, angle):
    import scipy.spatial

    return scipy.spatial.transform.Rotation.from_rotvec(angle * axis / sum(axis**2) ** 0.5).as_matrix()
