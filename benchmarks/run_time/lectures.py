"""Problems (rhs, start, parameters, end): every lecture that moves, and planets that come close to the sun."""

import math

from tam570.lectures import load, names

GM = 1.0  # m^3/s^2


def _planet(eccentricity):
    """Return a planet from the far end of an orbit with a period of 2 pi s; at the end it is on none of the axes."""
    far = 1 + eccentricity
    start = (far, 0.0, 0.0, 0.0, math.sqrt(GM * (1 - eccentricity) / far), 0.0)
    return load("planet").rates, start, {"gm": GM}, 20.0


def _example(name):
    lecture = load(name)
    return lecture.rates, lecture.START, dict(lecture.EXAMPLE), lecture.SECONDS


PROBLEMS = {
    **{name: _example(name) for name in names() if hasattr(load(name), "rates")},
    "planet, e = .9": _planet(0.9),
    "planet, e = .999": _planet(0.999),
}
