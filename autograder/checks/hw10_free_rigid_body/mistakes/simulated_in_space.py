"""omega-hat R stands for R omega-hat, but omega is in body components.

fails: attitude_follows_the_motion, rim_paths_are_drawn
also: omega-hat R stands for R omega-hat, or omega q for q omega, but omega is in body components
"""


def simulate(t, R, omega, *, inertia):
    from tam570.integrate import solve

    def rates(t, state, *, inertia):
        p, q, r, w, x, y, z = state
        return (
            *euler_equations((p, q, r), inertia=inertia),
            -0.5 * (x * p + y * q + z * r),
            0.5 * (w * p - y * r + z * q),
            0.5 * (w * q - z * p + x * r),
            0.5 * (w * r - x * q + y * p),
        )

    states = solve(rates, t, [*omega, 1.0, 0.0, 0.0, 0.0], parameters={"inertia": tuple(inertia)}, rtol=1e-12)
    return states[:, :3], _matrices(states[:, 3:]) @ R
