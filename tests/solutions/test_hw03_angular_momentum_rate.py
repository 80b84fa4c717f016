"""hw03: the reference against SymPy and exact rationals; which motions are taken for special, and which are not."""

from fractions import Fraction

import numpy as np
import pytest
import sympy

from tam570_grader.checks import assignments
from tam570_grader.checks.expect import Failed

hw = assignments.solution("hw03_angular_momentum_rate")
CHECKS = {
    check.name: check for check in assignments.assignment(assignments.find(), "hw03_angular_momentum_rate").checks
}
DRAW = np.random.default_rng(3)
ROUNDINGS = 1e-13  # relative to the size of the terms


def state():
    """Random vectors, six of them, over six decades."""
    return [DRAW.normal(size=3) * 10 ** DRAW.uniform(-3, 3) for _ in range(6)]


def size(r_p, v_p, a_p, r_c, v_c, a_c):
    """The size of the terms of a rate for 1 kg."""
    r, v, a = (np.linalg.norm(p) + np.linalg.norm(c) for p, c in zip((r_p, v_p, a_p), (r_c, v_c, a_c), strict=True))
    return r * a + v**2


@pytest.mark.parametrize("definition", "abc")
def test_the_rate_is_the_derivative(definition):
    """Route: SymPy differentiates the definition along unknown functions of time."""
    t = sympy.Symbol("t")
    p, c = (sympy.Matrix([sympy.Function(f"{name}{i}")(t) for i in range(3)]) for name in "pc")
    held = sympy.Matrix(sympy.symbols("h0:3"))
    arm = p - (held if definition == "a" else c)
    velocity = (p - c).diff(t) if definition == "c" else p.diff(t)
    rate = arm.cross(velocity).diff(t)
    symbols = [sympy.Matrix(sympy.symbols(f"{name}0:3")) for name in ("r", "v", "a", "s", "u", "b")]
    for path, orders in ((p, symbols[:3]), (c, symbols[3:])):
        for n in (2, 1, 0):
            rate = rate.subs(dict(zip(path.diff(t, n), orders[n], strict=True)))
    rate = rate.subs(dict(zip(held, symbols[3], strict=True)))
    function = sympy.lambdify(symbols, rate)
    for _ in range(20):
        vectors, mass = state(), 10 ** DRAW.uniform(-6, 6)
        expected = mass * function(*(v[:, None] for v in vectors)).ravel()
        found = hw.rate(definition, *vectors, mass=mass)
        np.testing.assert_allclose(found, expected, rtol=0, atol=ROUNDINGS * mass * size(*vectors))


def exactly(*vectors):
    return [np.array([Fraction(x) for x in vector.tolist()]) for vector in vectors]


@pytest.mark.parametrize("definition", "abc")
def test_every_result_has_full_digits(definition):
    """Route: the definitions in rational numbers."""
    for _ in range(20):
        vectors, mass = state(), 2.0 ** DRAW.integers(-20, 20)
        r_p, v_p, a_p, r_c, v_c, a_c = exactly(*vectors)
        velocity = v_p - v_c if definition == "c" else v_p
        surplus = {"a": 0 * v_p, "b": cross(v_p, v_c), "c": cross(a_c, r_p - r_c)}[definition]
        results = {
            "momentum": (
                hw.angular_momentum(definition, *vectors[:2], *vectors[3:5], mass=mass),
                cross(r_p - r_c, velocity),
            ),
            "moment": (hw.moment(vectors[0], vectors[2], vectors[3], mass=mass), cross(r_p - r_c, a_p)),
            "discrepancy": (hw.discrepancy(definition, *vectors, mass=mass), surplus),
        }
        for name, (found, expected) in results.items():
            scale = (
                size(*vectors)
                if name != "momentum"
                else np.prod([np.linalg.norm(vectors[i]) + np.linalg.norm(vectors[i + 3]) for i in (0, 1)])
            )
            error = np.abs(found - mass * expected.astype(float))
            assert np.all(error <= ROUNDINGS * mass * scale), name


def cross(a, b):
    return np.array([a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))])


@pytest.mark.parametrize("definition", "abc")
def test_without_motion_of_C_rate_is_moment(definition):
    vectors = state()
    vectors[4:] = np.zeros((2, 3))
    assert np.all(hw.discrepancy(definition, *vectors, mass=2.0) == 0)
    moment = hw.moment(vectors[0], vectors[2], vectors[3], mass=2.0)
    assert np.all(hw.rate(definition, *vectors, mass=2.0) == moment)


@pytest.mark.parametrize("definition", ["d", "", "ab", "A", None, 1])
def test_other_definitions_are_refused(definition):
    vectors = state()
    for refused in (
        lambda: hw.angular_momentum(definition, *vectors[:4], mass=1.0),
        lambda: hw.rate(definition, *vectors, mass=1.0),
        lambda: hw.discrepancy(definition, *vectors, mass=1.0),
        lambda: hw.special_motion(definition),
    ):
        with pytest.raises(ValueError, match="definition"):
            refused()


# Special motions: what the hidden check takes and what it does not


class Answer:
    """A student whose special motion is this."""

    def __init__(self, p, c):
        self.motion = np.asarray(p, float), np.asarray(c, float)

    def special_motion(self, definition):
        return self.motion


def judge(definition, p, c):
    CHECKS[f"special_motion_of_{definition}"].run(Answer(p, c), None)


def turned(p, c, far=100.0):
    """The same motion in a frame turned at random, far from the origin: all coefficients are rounded."""
    matrix, shift = np.linalg.qr(DRAW.normal(size=(3, 3)))[0], DRAW.normal(size=3) * far
    p, c = (np.asarray(f, float) @ matrix.T for f in (p, c))
    p[0] += shift
    c[0] += shift
    return p, c


def scaled(p, c, length, time):
    """The same motion in other units."""
    return tuple(length * np.asarray(f, float) * float(time) ** np.arange(len(f))[:, None] for f in (p, c))


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
def test_any_special_motion_is_taken(definition, p, c):
    judge(definition, p, c)
    for _ in range(2):
        judge(definition, *turned(p, c))
    judge(definition, *turned(p, c, 1e7))  # as far as the surface of the Earth is from its centre
    judge(definition, *scaled(p, c, 1e-6, 1.0))
    judge(definition, *scaled(p, c, 1e6, 1.0))
    judge(definition, np.vstack([p, np.zeros((4, 3))]), c)


@pytest.mark.parametrize(("definition", "p", "c"), SPECIAL.values(), ids=SPECIAL.keys())
def test_none_is_special_for_the_other_definition(definition, p, c):
    with pytest.raises(Failed, match="Rate and moment differ"):
        judge({"b": "c", "c": "b"}[definition], p, c)


@pytest.mark.parametrize(("definition", "p", "c"), SPECIAL.values(), ids=SPECIAL.keys())
def test_a_special_motion_disturbed_is_none(definition, p, c):
    """One part in a million of one coefficient, whichever moves the two apart."""
    disturbed = np.vstack([p, np.zeros((3, 3))])
    disturbed[1:4] += 1e-6 * DRAW.normal(size=(3, 3))
    with pytest.raises(Failed, match="Rate and moment differ"):
        judge(definition, disturbed, c)


@pytest.mark.parametrize(("definition", "p", "c"), SPECIAL.values(), ids=SPECIAL.keys())
def test_no_distance_hides_that_a_motion_is_none(definition, p, c):
    disturbed = np.vstack([p, np.zeros((3, 3))])
    disturbed[1:4] += [[0.5, 0.25, 1], [0.25, 1, -0.5], [1, -0.5, 0.25]]
    for far in (1e7, 1e10, 1e13):
        with pytest.raises(Failed):
            judge(definition, *turned(disturbed, c, far))


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


@pytest.mark.parametrize(("definition", "p", "c", "says"), SEEMING.values(), ids=SEEMING.keys())
def test_none_that_only_seems_special_is_taken(definition, p, c, says):
    with pytest.raises(Failed, match=says):
        judge(definition, p, c)
    with pytest.raises(Failed, match=says):
        judge(definition, *turned(p, c))


def test_a_property_at_many_times_is_not_one_at_every_time():
    """P stops at 0, 1/40, ..., 1 to rest there for an instant: no sampling would tell, the coefficients do."""
    stops = np.poly(np.linspace(0, 1, 9))[::-1]
    p = np.outer(np.polynomial.polynomial.polyint(stops), [0.0, 1.0, 0.0])
    p[0] = [0, 1, 0]
    with pytest.raises(Failed, match="differ"):
        judge("b", p, LINE)


def test_the_solutions_motions_are_special():
    for definition in "bc":
        judge(definition, *hw.special_motion(definition))
