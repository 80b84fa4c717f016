"""With only two times both rows are the start.

fails: special_bodies_move_too
"""

_right = simulate


def simulate(t, R, omega, *, inertia):
    omegas, rotations = _right(t, R, omega, inertia=inertia)
    last = 0 if len(t) == 2 else slice(None)
    return omegas * 0 + omegas[last], rotations * 0 + rotations[last]
