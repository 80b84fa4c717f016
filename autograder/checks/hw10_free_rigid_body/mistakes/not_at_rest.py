"""Time is measured in 1/|omega|: a body at rest divides by zero.

fails: special_bodies_move_too
names: simulate raised ValueError for a wheel at rest
"""

_right_simulate = simulate


def simulate(t, R, omega, *, inertia):
    speed = np.linalg.norm(omega)
    omegas, rotations = _right_simulate(t * speed, R, omega / speed, inertia=inertia)
    return omegas * speed, rotations
