"""The turns about x, y and z are rounded to ten places.

fails: turns_about_the_coordinate_axes, space_sequence_takes_the_first_step_first, body_sequence_takes_the_axes_along
names: the numbers are rounded
numerics: ten digits of sixteen
"""

_right_axis_rotation = axis_rotation


def axis_rotation(axis, angle):
    return np.round(_right_axis_rotation(axis, angle), 10)
