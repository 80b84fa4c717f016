"""What np.allclose calls zero is treated as zero; small motions count, too.

fails: solution_holds_without_gravity_and_from_any_time, derivative_is_velocity_and_force_over_mass
where: a very small motion
"""

_right_solution, _right_derivative = solution, state_derivative


def solution(t, position, velocity, **parameters):
    moves = not (np.allclose(position, 0) and np.allclose(velocity, 0))
    return _right_solution(t, moves * position, moves * velocity, **parameters)


def state_derivative(t, state, **parameters):
    return _right_derivative(t, state if not np.allclose(state, 0) else 0 * state, **parameters)
