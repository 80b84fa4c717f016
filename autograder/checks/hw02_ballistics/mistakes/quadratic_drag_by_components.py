"""The drag is quadratic in each component, -c vx |vx| and -c vy |vy|; it should be linear.

fails: rates_are_newtons, simulation_follows_the_motion, both_paths_are_drawn
"""


def _rates(t, state, rate, gravity):
    _, _, vx, vy = state
    return vx, vy, -rate * vx * abs(vx), -rate * vy * abs(vy) - gravity
