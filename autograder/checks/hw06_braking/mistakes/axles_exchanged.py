"""The locked axle and the free one are exchanged.

fails: axle_load_balances_the_weight, friction_opposes_the_sliding, equations_of_motion, simulate_brakes, kinetic_energy_of_G_and_of_turning, growth_rate_is_the_slope, critical_speed_is_where_growth_begins, small_yaw_rate_is_the_linear_solution, mechanics_refuses_other_axles, stability_refuses_other_axles
"""


def _axles(locked, front, rear):
    if locked not in ("front", "rear"):
        raise ValueError
    return (-rear, front + rear) if locked == "rear" else (front, -front - rear)
