"""Right functions of hw03 in terms of others, which a student's results follow where those are the student's own."""


def rate(definition, r_p, v_p, a_p, r_c, v_c, a_c, *, mass):
    """The angular momentum along parabolas, a cubic in time, differenced; the point C' of definition a stays."""

    def difference(t):
        after, before = (
            angular_momentum(
                definition,
                r_p + s * v_p + s**2 / 2 * a_p,
                v_p + s * a_p,
                *((r_c, v_c) if definition == "a" else (r_c + s * v_c + s**2 / 2 * a_c, v_c + s * a_c)),
                mass=mass,
            )
            for s in (t, -t)
        )
        return (after - before) / (2 * t)

    return (4 * difference(1.0) - difference(2.0)) / 3
