"""The load has one distance over the other; it should have one distance over the wheelbase.

fails: axle_load_balances_the_weight, friction_opposes_the_sliding, equations_of_motion, simulate_brakes, growth_rate_is_the_slope, small_yaw_rate_is_the_linear_solution, mechanics_refuses_other_axles
"""


def axle_load(locked, *, mass, front, rear, gravity):
    free, arm = _axles(locked, front, rear)
    return mass * gravity * abs(free) / (abs(arm) - abs(free))
