"""hw03: which motions the hidden check takes for special, and which not."""

from types import SimpleNamespace

import numpy as np
import pytest

from tam570_grader.checks import assignments
from tam570_grader.checks.expect import Failed

CHECKS = {
    check.name: check for check in assignments.assignment(assignments.find(), "hw03_angular_momentum_rate").checks
}
DRAW = np.random.default_rng(3)


def run_check(definition, p, c):
    """The hidden check of a student whose special motion is this."""
    motion = np.asarray(p, float), np.asarray(c, float)
    CHECKS[f"special_motion_of_{definition}"].run(SimpleNamespace(special_motion=lambda _: motion), None)


def turned(p, c, far=100.0):
    """The same motion in a frame turned at random, far from the origin: all coefficients are rounded."""
    matrix, shift = np.linalg.qr(DRAW.normal(size=(3, 3)))[0], DRAW.normal(size=3) * far
    p, c = (np.asarray(f, float) @ matrix.T for f in (p, c))
    p[0] += shift
    c[0] += shift
    return p, c


SPECIAL = {
    "P at rest, C speeding along a line": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]),
    "P at rest, C on a curve": ("b", [[5, 0, 1]], [[0, 0, 0], [0, 2, 0], [0, 0, 3], [1, 0, 0]]),
    "parallel lines": ("b", [[0, 1, 0], [2, 0, 0], [0, 0, 0], [-1, 0, 0]], [[0, 0, 0], [1, 0, 0], [1, 0, 0]]),
    "parallel lines, P uniform": ("b", [[0, 0, 1], [-1, 0, 0]], [[0, 0, 0], [-2, 0, 0], [1 / 3, 0, 0]]),
    "P twice as fast on a similar curve": (
        "b",
        [[0, 0, 1], [2, 0, 0], [0, 2, 0], [0, 0, 2]],
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]],
    ),
    "P above a thrown C": ("c", [[0, 1, 0], [1, 1, 0], [0, -1, 0]], [[0, 0, 0], [1, 0, 0], [0, -1, 0]]),
    "P below it, and falling": ("c", [[0, -1, 0], [1, 1, 0], [0, -3, 0]], [[0, 0, 0], [1, 1, 0], [0, -1, 0]]),
    "C about a uniform P": ("c", [[0, 0, 0], [0, 7, 0]], [[0, 0, 2], [0, 7, 0], [0, 0, -1]]),
    "C with an acceleration that grows": (
        "c",
        [[0, 0, 4], [1, 0, 2], [0, 0, -2], [0, 0, 0.1]],
        [[0, 0, 0], [1, 0, 1], [0, 0, -2], [0, 0, 0.1]],
    ),
    "P at rest on the line of C": ("c", [[0, 0, 2]], [[0, 0, 0], [0, 0, 1], [0, 0, 0.25]]),
}
ON_ONE_LINE = SPECIAL.pop("P at rest on the line of C")  # b holds too


@pytest.mark.parametrize(("definition", "p", "c"), SPECIAL.values(), ids=SPECIAL.keys())
def test_any_special_motion_is_taken_for_its_definition_and_none_next_to_it(definition, p, c):
    """Wherever it is, in any units and with zeros appended; not one whose P is disturbed, however far away."""
    run_check(definition, p, c)
    run_check(definition, np.vstack([p, np.zeros((4, 3))]), c)
    for far in (100.0, 100.0, 1e7):  # as far as the surface of the Earth is from its centre
        run_check(definition, *turned(p, c, far))
    for length in (1e-6, 1e6):
        run_check(definition, length * np.asarray(p), length * np.asarray(c))
    with pytest.raises(Failed, match="differ"):
        run_check({"b": "c", "c": "b"}[definition], p, c)
    p = np.vstack([p, np.zeros((3, 3))])
    away = 1e-6 * DRAW.normal(size=(3, 3))
    with pytest.raises(Failed, match="differ"):
        run_check(definition, p + np.pad(away, ((1, len(p) - 4), (0, 0))), c)
    p[1:4] += [[0.5, 0.25, 1], [0.25, 1, -0.5], [1, -0.5, 0.25]]
    for far in (1e7, 1e10, 1e13):
        with pytest.raises(Failed):
            run_check(definition, *turned(p, c, far))


LINE = [[0, 0, 0], [1, 0, 0], [1, 0, 0]]
SEEMING = {
    "C at rest": ("b", [[0, 1, 0]], [[0, 0, 0]], "velocity of C"),
    "C uniform": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0]], "acceleration of C"),
    "C stops at the start": ("b", [[0, 1, 0]], [[0, 0, 0], [0, 0, 0], [1, 0, 0]], "velocity of C"),
    "C stops at the end": ("b", [[0, 1, 0]], [[0, 0, 0], [-2, 0, 0], [1, 0, 0]], "velocity of C"),
    "C turns back": ("b", [[0, 1, 0]], [[0, 0, 0], [-0.3, 0, 0], [1, 0, 0]], "velocity of C vanishes at t = 0.15"),
    "C stops as (t - 1/3)^2": (
        "b",
        [[0, 1, 0]],
        [[0, 0, 0], [1 / 9, 0, 0], [-1 / 3, 0, 0], [1 / 3, 0, 0]],
        "velocity of C vanishes at t = 0.33",
    ),
    "C's acceleration turns round": (
        "b",
        [[0, 1, 0]],
        [[0, 0, 0], [9, 0, 0], [-1, 0, 0], [0.5, 0, 0]],
        "acceleration of C vanishes at t = 0.67",
    ),
    "an acceleration of roundings": ("b", [[0, 1, 0]], [[0, 0, 0], [1, 0, 0], [1e-16, 0, 0]], "acceleration of C"),
    "P is C": ("b", LINE, LINE, "meet"),
    "P meets C": ("b", [[0.75, 0, 0]], LINE, "meet at t = 0.5"),
    "P and C together": ("b", [[0, 1, 0], *LINE[1:]], LINE, "along with C"),
    "both hold": ("b", [[5, 0, 0], [2, 0, 0]], LINE, "Definition c has"),
    "both hold, P at rest": (*ON_ONE_LINE, "Definition b has"),
    "at t = 0 alone": ("b", [[0, 1, 0], [0, 0, 0], [0, 1, 0]], LINE, "differ"),
    "no property": ("c", [[0, 1, 0], [0, 0, 2]], LINE, "differ"),
    "too long": ("b", np.ones((101, 3)), LINE, "more than 100"),
}


@pytest.mark.parametrize(("definition", "p", "c", "flaw"), SEEMING.values(), ids=SEEMING.keys())
def test_none_that_only_seems_special_is_taken(definition, p, c, flaw):
    with pytest.raises(Failed, match=flaw):
        run_check(definition, p, c)
    with pytest.raises(Failed, match=flaw):
        run_check(definition, *turned(p, c))
