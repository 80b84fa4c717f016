"""space_sequence takes the steps out of the list that it is given.

fails: space_sequence_takes_the_first_step_first
names: space_sequence changes the arrays
"""


def space_sequence(steps):
    R = np.eye(3)
    while steps:
        R = R @ axis_rotation(*steps.pop())
    return R
