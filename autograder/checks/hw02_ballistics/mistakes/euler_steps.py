"""Ten steps of Euler's method go from each time to the next.

fails: simulation_follows_the_motion, both_paths_are_drawn
numerics: a method of first order
names: take smaller steps | tighten
"""


def simulate(t, speed, angle, **known):
    rows = [np.array([0, 0, speed * np.cos(angle), speed * np.sin(angle)])]
    for step in np.diff(t):
        y = rows[-1]
        for _ in range(10):
            y = y + step / 10 * np.asarray(state_derivative(0, y, **known))
        rows.append(y)
    return np.array(rows)
