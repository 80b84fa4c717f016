"""Mistakes that nobody has written down are found by trying; what could be two things is not named."""

import math

import numpy as np
import pytest

from tam570_grader.checks.case import Case
from tam570_grader.diagnosis.search import general
from tam570_grader.sandbox.function import Call

SOLUTION = """
import numpy as np

def weight(mass, height, *, gravity, length):
    return mass * gravity * height + mass * length ** 2 / 2

def turned(v, *, angle):
    x, y = v
    return x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle)

def polar(x, y):
    return np.hypot(x, y), np.arctan2(y, x)

def cross(a, b):
    return np.array([_part(a, b, 1, 2), _part(a, b, 2, 0), _part(a, b, 0, 1)])

def _part(a, b, i, j):
    return a[i] * b[j] - a[j] * b[i]

def lift(length, mass, *, gravity):
    return mass * length ** 2 - mass * gravity * length

def swing(angle, *, mass):
    return 2 * mass * np.sin(angle / 2) ** 2

def rod(x, y):
    return np.array([[[0.0, 1.0], [x, y]]])

def forces(x, y):
    return np.array([[x, y], [y ** 2, x + y]])

def fall(t, height, speed, *, gravity, drag):
    fallen = np.asarray(t) - t[0]
    return np.column_stack([height + speed * fallen - gravity * fallen ** 2 / 2, speed - gravity * fallen])

def tumble(rate, *, mass, radius, inertia):
    return inertia[0] * rate ** 2 + inertia[1] * rate + mass * radius

def stairs(n, m):
    total = 0.0
    while n > 0:
        total, n = total + n, n - 1
    return total + m ** 2
"""
DRAW = np.random.default_rng(2)


def weights(wrong):
    known = [dict(zip(("mass", "height", "gravity", "length"), DRAW.uniform(0.5, 3, 4), strict=True)) for _ in range(4)]
    return [
        Call("weight", Case(one["mass"], one["height"], gravity=one["gravity"], length=one["length"]), wrong(**one))
        for one in known
    ]


def vectors(wrong):
    cases = [(DRAW.normal(size=2), DRAW.uniform(0.2, 1.4)) for _ in range(4)]
    return [Call("turned", Case(v, angle=angle), wrong(v, angle)) for v, angle in cases]


def pairs(wrong):
    signs = np.array([[1, 1], [1, -1], [-1, 1], [-1, -1]])  # one in each quadrant
    places = (signs * DRAW.uniform(0.2, 2, (4, 2))).tolist()
    return [Call("polar", Case(*place), wrong(math.hypot(*place), math.atan2(*place[::-1]))) for place in places]


def products(wrong):
    return [Call("cross", Case(*pair), wrong(*pair)) for pair in DRAW.normal(size=(4, 2, 3))]


def swings(wrong):
    return [Call("swing", Case(angle, mass=2.0), 2 * wrong(angle)) for angle in DRAW.uniform(0.3, 1.2, 4)]


def lifts(wrong):
    return [Call("lift", Case(x, m, gravity=9.0), wrong(x, m)) for x, m in DRAW.uniform(0.3, 3, (4, 2))]


def tables(wrong):
    return [Call("forces", Case(x, y), wrong(np.array([[x, y], [y**2, x + y]]))) for x, y in DRAW.uniform(1, 3, (4, 2))]


def rods(wrong):
    return [Call("rod", Case(x, y), wrong(np.array([[[0.0, 1.0], [x, y]]]))) for x, y in DRAW.uniform(1, 3, (4, 2))]


def falls(wrong):
    t = np.linspace(1, 3, 9) ** 2
    known = {"gravity": 2.0, "drag": 0.7}
    return [Call("fall", Case(t, 1.5, 0.8, **known), wrong(t - t[0], 1.5, 0.8, **known))]


def tumbles(wrong):
    known = [(rate, {"mass": m, "radius": r, "inertia": (a, 2.0)}) for rate, m, r, a in DRAW.uniform(0.5, 3, (4, 4))]
    return [Call("tumble", Case(rate, **body), wrong(rate, **body)) for rate, body in known]


def turned(v, angle):
    c, s = math.cos(angle), math.sin(angle)
    return np.array([[c, -s], [s, c]]) @ v


@pytest.mark.parametrize(
    ("calls", "says"),
    [
        (
            lambda: weights(lambda mass, height, gravity, length: mass * gravity * height),
            "length is ignored, as if it were zero",
        ),
        (
            lambda: weights(lambda mass, height, gravity, length: gravity * height + length**2 / 2),
            "In weight, mass is ignored, as if it were 1",
        ),
        (
            lambda: weights(lambda mass, height, gravity, length: mass * (gravity * height - length**2 / 2)),
            "In weight, the sign of a term with length, mass is reversed",
        ),
        (
            lambda: weights(lambda mass, height, gravity, length: mass * gravity * height + mass * length / 2),
            "In weight, an exponent with length is one too large or too small",
        ),
        (
            lambda: weights(lambda mass, height, gravity, length: mass * 9.81 * height + mass * length**2 / 2),
            "In weight, gravity is ignored, as if it were 9.81",
        ),
        (
            lambda: weights(
                lambda mass, height, gravity, length: mass * gravity * height + mass * (length * mass) ** 2 / 2
            ),
            "In weight, length has a factor mass too many",
        ),
        (
            lambda: weights(
                lambda mass, height, gravity, length: (mass * gravity * height + mass * length**2 / 2) ** 0.5
            ),
            "The result of weight is the square root of the right one",
        ),
        (
            lambda: weights(
                lambda mass, height, gravity, length: mass * (gravity * height + length**2 / 2) / gravity**2
            ),
            "The result of weight should be multiplied by gravity squared",
        ),
        (
            lambda: falls(lambda t, h, v, gravity, drag: np.column_stack([h + v * t + t**2, v + 2 * t])),
            "In fall, gravity has the opposite sign",
        ),
        (  # at a tolerance of its own
            lambda: falls(lambda t, h, v, gravity, drag: np.column_stack([h + v * t - 0.7 * t**2, v - 1.400001 * t])),
            "In fall, gravity has a factor drag too many",
        ),
        (
            lambda: falls(lambda t, h, v, gravity, drag: np.column_stack([h + v * t - t**2, v - 4 * t])),
            "In fall, a term with gravity counts twice",
        ),
        (
            lambda: tumbles(lambda rate, mass, radius, inertia: (inertia[0] * rate + 2) * rate / 3 + mass * radius / 3),
            "The result of tumble is 0.3333 times the right one for any input",
        ),
        (
            lambda: tumbles(lambda rate, mass, radius, inertia: (inertia[0] * rate + 2) * rate + mass * radius + 1.25),
            "The result of tumble is off by 1.25 for any input",
        ),
        (
            lambda: tumbles(
                lambda rate, mass, radius, inertia: (
                    (inertia[0] + mass * radius**2) * rate**2 + inertia[1] * rate + mass * radius
                )
            ),
            "In tumble, component 1 of inertia has mass radius^2 too many",
        ),
        (
            lambda: tables(lambda right: right + [[0.0, 0.0], [0.3, 0.0]] * right**2),
            "The result of forces is wrong in row 2, column 1 alone",
        ),
        (lambda: pairs(lambda r, angle: (r, abs(angle))), "The second result of polar has lost its sign"),
        (
            lambda: pairs(lambda r, angle: (r, math.atan(math.tan(angle)))),
            "The second result of polar is the arctan of a ratio",
        ),
        (
            lambda: pairs(lambda r, angle: (r, max(angle, 0.0))),
            "The second result of polar is zero where the right one is negative",
        ),
        (
            lambda: pairs(lambda r, angle: (r, math.sqrt(max(angle, 0.0)))),
            "The second result of polar is the square root of the right one, and zero",
        ),
        (
            lambda: pairs(lambda r, angle: (r, angle / (2 * math.pi))),
            "The second result of polar lacks the factor 2 pi",
        ),
        (lambda: swings(lambda angle: 1 + math.cos(angle)), "In swing, a cosine with angle has the wrong sign"),
        (  # length and gravity explain it, too; one slip alone does
            lambda: lifts(lambda length, mass: mass * length**2 + 9.0 * mass * length),
            "In lift, the sign of a term with gravity, length, mass is reversed",
        ),
        (  # gravity lacks it, or height
            lambda: weights(lambda mass, height, gravity, length: gravity * height + mass * length**2 / 2),
            "In weight, a factor with mass is missing",
        ),
        (
            lambda: weights(lambda mass, height, gravity, length: mass * gravity * height + mass * length**2),
            "In weight, a term with length, mass counts twice",
        ),
        (
            lambda: lifts(lambda length, mass: -mass * length**2 - 9.0 * mass * length),
            "In lift, the sign of a term with length, mass is reversed",
        ),
        (
            lambda: vectors(lambda v, angle: (v @ [1, -1] * math.cos(angle), v @ [1, 1] * math.cos(angle))),
            "In turned, the wrong function is used with angle",
        ),
        (lambda: tables(lambda forces: forces[::-1]), "The result of forces has rows 1 and 2 exchanged"),
        (lambda: tables(lambda forces: forces * [1, -1]), "The result of forces has the opposite sign in column 2"),
        (lambda: rods(lambda rod: rod[:, ::-1]), "The result of rod has ends 1 and 2 exchanged"),
        (lambda: weights(lambda **known: 0.0), "The result of weight is zero"),
        (lambda: vectors(lambda v, angle: turned(v, -angle)), "In turned, angle has the opposite sign"),
        (lambda: vectors(lambda v, angle: turned(v, math.radians(angle))), "In turned, angle is read as degrees"),
        (lambda: vectors(lambda v, angle: turned(v, angle)[::-1]), "has components 1 and 2 exchanged"),
        (lambda: vectors(lambda v, angle: turned(v, angle) * [-1, 1]), "has the opposite sign in component 1"),
        (lambda: pairs(lambda r, angle: (-r, -angle)), "The results of polar have the opposite sign"),
        (lambda: pairs(lambda r, angle: (r, -angle)), "The second result of polar has the opposite sign"),
        (lambda: products(lambda a, b: np.cross(b, a)), "The result of cross has the opposite sign"),
        (lambda: products(lambda a, b: 4 * np.cross(a, b)), "The result of cross is 4 times the right one for any"),
        (lambda: products(lambda a, b: np.cross(a, b) * [1, -1, 1]), "has the opposite sign in component 2"),
    ],
)
def test_it_is_named_by_what_it_does(calls, says):
    assert says in general(SOLUTION, calls()).message


@pytest.mark.parametrize(
    "calls",
    [
        lambda: weights(lambda mass, height, gravity, length: mass * gravity * height + mass * length**2 / 2),  # right
        lambda: weights(lambda mass, height, gravity, length: mass * (gravity * height - length**2 / 2))[:1],
        lambda: weights(lambda mass, height, gravity, length: mass + gravity),
        lambda: [*vectors(lambda v, angle: -turned(v, angle)), *products(lambda a, b: np.cross(b, a))],  # two are wrong
        lambda: [*vectors(turned), Call("turned", Case(np.ones(2), angle=0.1), None)],
        lambda: products(lambda a, b: 4 * np.linalg.norm(a) * np.cross(a, b)),
    ],
)
def test_what_is_no_one_thing_is_not_named(calls):
    assert general(SOLUTION, calls()) is None


def test_results_of_several_forms_are_searched_too():
    """An array and a number, of which nothing is the wrong one by one slip."""
    solution = "import numpy as np\ndef both(x): return np.array([x, 2.0]), x"
    calls = [Call("both", Case(x), (np.array([x**3, 2.0]), x + 1.0)) for x in (1.5, 2.5)]
    assert general(solution, calls) is None


def test_what_comes_near_a_motion_does_not_explain_it():
    """A factor of .705 is not one of drag, .7, for a motion that is accurate."""
    calls = falls(lambda t, h, v, gravity, drag: np.column_stack([h + v * t - 0.705 * t**2, v - 1.41 * t]))
    assert general(SOLUTION, calls) is None


def test_a_variant_that_never_ends_is_passed_over():
    """`stairs` with another sign in its step goes round for ever; the slip in the last line comes after that one."""
    calls = [Call("stairs", Case(n, m), n * (n + 1) / 2 + m) for n, m in ((2, 3.0), (3, 5.0), (4, 7.0))]
    assert general(SOLUTION, calls).message == "In stairs, an exponent with m is one too large or too small"


QUARTER = """

def energy(state, *, mass, gravity):
    return mass * (state[2] ** 2 + state[3] ** 2) / 4 + mass * gravity * state[1]
"""


def test_it_is_said_in_the_feedback(grade, solution_text):
    slug = "hw05_constrained_pendulum"
    (mark,) = [mark for mark in grade(slug, solution_text(slug) + QUARTER).checks if mark.outcome == "failed"]
    assert (
        "Your numbers match this mistake: In energy, a number with mass, state is twice or half the right one."
        in mark.message
    )
