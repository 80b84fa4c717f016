"""Patches the worker so that its replies contain arrays in place of words and flags.

deserves: nothing certain
"""

import sys

import numpy as np

ODD = [
    {"value": np.eye(3), "changed": np.ones(3)},
    {"error": {"kinds": ["Odd"], "text": np.ones(3), "line": np.ones(2)}},
    {"value": [np.ones(3), {"of": 1}], "changed": False},
]


def patched(reply):
    frame = sys._getframe()
    while frame:
        if callable(frame.f_globals.get("answer")):
            frame.f_globals["answer"] = lambda *args: reply
        frame = frame.f_back


def skew(v):
    patched(ODD[0])


def rotation_matrix(axis, angle):
    patched(ODD[1])


def rotate(r, axis, angle):
    patched(ODD[2])
