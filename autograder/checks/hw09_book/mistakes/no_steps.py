"""Both sequences begin with the first step, and fail without one.

fails: space_sequence_takes_few_steps, body_sequence_takes_few_steps
names: sequence raised TypeError for no turns at all
"""

import functools


def space_sequence(steps):
    return functools.reduce(lambda R, S: S @ R, [axis_rotation(*step) for step in steps])


def body_sequence(steps):
    return functools.reduce(lambda R, S: R @ S, [axis_rotation(*step) for step in steps])
