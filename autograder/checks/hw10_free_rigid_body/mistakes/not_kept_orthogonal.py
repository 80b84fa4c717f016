"""R goes on by R + dt R omega-hat, and is a rotation no more.

fails: attitude_follows_the_motion, rim_paths_are_drawn
numerics: a method of first order
names: take smaller steps
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    omegas, _ = _right_simulate(t, R, omega, inertia=inertia)
    rotations = [np.array(R)]
    for dt, w in zip(np.diff(t), omegas):
        for _ in range(20):
            rotations.append(rotations[-1] + dt / 20 * attitude_rate(rotations[-1], w))
    return omegas, np.array(rotations[::20])
