"""Returns the correct answers of the visible tests, and wrong answers for other inputs.

Published against graders in Moodle (Kratzke, "Smart Like a Fox", CSEDU 2019: overfitting).

deserves: 5
"""

import numpy

_right = {"skew": globals().get("skew"), "rotate": globals().get("rotate")}


def rotation_matrix(axis, angle):
    if angle == numpy.pi / 2:
        return [[0, -1, 0], [1, 0, 0], [0, 0, 1]]
    return numpy.eye(3)
