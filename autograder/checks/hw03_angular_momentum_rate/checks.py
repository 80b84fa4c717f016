"""Hidden checks of hw03. P and C move along random polynomials; what is right is the derivative of their products."""

from functools import partial

import numpy as np

from tam570_grader import array, check, expect, expect_that, given, group, once, suspect

RESULTS = {
    "moment": array(3),
    "angular_momentum": array(3),
    "rate": array(3),
    "discrepancy": array(3),
    "special_motion": group(array(None, 3), array(None, 3)),
}
NEEDS = ("numpy",)
MANUAL = {"a": (2, "in words: which definitions have rate = moment in general, which in special cases, and why")}

POINTWISE = 1e-8  # a few roundings make 1e-15, a rate by differences of a Taylor series 1e-11
NEARLY = 1e-4  # off by less, a rate is right in principle, to choose the words
IDENTITY = 1e-12  # relative, of a coefficient: those of a motion, and so their products, are rounded to 1e-16 each
FAR_OFF = 1e-6  # the same of a motion far from O: 1e7 m away from it one metre is rounded to 1e-9
CERTAIN = 1e-9  # relative, of a coefficient that is there for certain
NOTHING = 1e-8  # of the largest: a polynomial that vanishes twice is found to be below the root of rounding
LONGEST = 100  # coefficients of a motion that are looked at


def cross(p, q):
    """Coefficients (k, 3) of the vector product of two vectors of polynomials."""
    product = np.zeros((len(p) + len(q) - 1, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        product[:, k] = np.convolve(p[:, i], q[:, j]) - np.convolve(p[:, j], q[:, i])
    return product


def derivative(p):
    return p[1:] * np.arange(1, len(p))[:, None] if len(p) > 1 else np.zeros((1, 3))


def difference(p, q):
    longer = max(len(p), len(q))
    p, q = (np.vstack([f, np.zeros((longer - len(f), 3))]) for f in (p, q))
    return p - q


def value(p, t):
    """Of a vector of polynomials, at numbers t: (..., 3)."""
    return np.moveaxis(np.polynomial.polynomial.polyval(t, p), 0, -1)


def momentum(definition, p, c, mass, now):
    """The angular momentum as polynomials in time; C' is where C is at the time `now`."""
    held = value(c, now)[None] if definition == "a" else c
    velocity = derivative(difference(p, c)) if definition == "c" else derivative(p)
    return mass * cross(difference(p, held), velocity)


@once
def motions(draw):
    """Random motions of P and C, and for each the mass, the time, and the state (r_p, v_p, a_p, r_c, v_c, a_c) then."""
    cases = []
    for _ in range(8):
        p, c = draw.normal(size=(2, 5, 3)) * draw.uniform(0.3, 3, (2, 5, 1))
        mass, now = 10 ** draw.uniform(-1, 1), draw.uniform(-0.8, 0.8)
        cases.append((p, c, mass, now, state_of(p, c, now)))
    return cases + plain_motions(draw)


def state_of(p, c, now):
    """The state (r_p, v_p, a_p, r_c, v_c, a_c) at a time."""
    orders = (f for path in (p, c) for f in (path, derivative(path), derivative(derivative(path))))
    return tuple(value(f, now) for f in orders)


# what is zero in each, by the rows of P's and of C's coefficients: position, velocity and acceleration now
PLAIN = {
    "P at the origin": ([0], []),
    "C at the origin": ([], [0]),
    "P at rest": ([1], []),
    "C at rest": ([], [1]),
    "C fixed": ([], [1, 2]),
    "no force on P": ([2], []),
    "C unaccelerated": ([], [2]),
    "both at rest": ([1], [1]),
    "P fixed at the origin": ([0, 1, 2], []),
    "C fixed at the origin": ([], [0, 1, 2]),
}


@once
def plain_motions(draw):
    """As `motions`, at the time 0: P or C at the origin, or at rest, or unaccelerated; together; in a plane."""
    cases = []
    for zero_p, zero_c in PLAIN.values():
        p, c = draw.normal(size=(2, 3, 3))
        p[zero_p], c[zero_c] = 0.0, 0.0
        cases.append((p, c, 1.0))
    p, c = draw.normal(size=(2, 3, 3))
    cases.append((np.vstack([c[:1], p[1:]]), c, 2.0))  # P at C
    cases.append((np.vstack([p[:1], c[1:]]), c, 2.0))  # P moves along with C
    cases.append((p * [1, 1, 0], c * [1, 1, 0], 1.0))  # in a plane
    cases.append((np.round(3 * p), np.round(3 * c), 1.0))  # whole numbers
    return [(p, c, mass, 0.0, state_of(p, c, 0.0)) for p, c, mass in cases]


def kind_of(state, kind):
    """What to call a state: which of its vectors are zero."""
    names = ("r_p", "v_p", "a_p", "r_c", "v_c", "a_c")
    zero = [name for name, vector in zip(names, state, strict=True) if not np.any(vector)]
    if np.array_equal(state[0], state[3]):
        zero.append("r_p - r_c")
    if np.array_equal(state[1], state[4]):
        zero.append("v_p - v_c")
    return kind + (f", {' and '.join(zero)} zero" if zero else "")


def size(state, mass):
    """The size of a moment, N m, and of an angular momentum, kg m^2/s, in such a state."""
    r, v, a = (np.linalg.norm(state[i]) + np.linalg.norm(state[i + 3]) for i in range(3))
    return mass * (r * a + v**2), mass * r * v


def moment_variant(says, wrong):
    return suspect(says, moment=lambda r_p, a_p, r_c, mass: wrong(r_p, a_p, r_c, mass))


MOMENT_SUSPECTS = [
    moment_variant("the moment about O in place of C", lambda r_p, a_p, r_c, m: np.cross(r_p, m * a_p)),
    moment_variant("the lever arm from P to C", lambda r_p, a_p, r_c, m: np.cross(r_c - r_p, m * a_p)),
    moment_variant("the moment without the mass", lambda r_p, a_p, r_c, m: np.cross(r_p - r_c, a_p)),
]


@check(points=1, part="a", suspects=MOMENT_SUSPECTS)
def moment_is_about_C(student, draw):
    """moment: that of the total force on P, about C."""
    cases = motions(draw)
    kinds = [kind_of(state, "random positions and accelerations") for *_, state in cases]
    calls = [given(s[0], s[2], s[3], mass=m).on(kind) for (*_, m, _, s), kind in zip(cases, kinds, strict=True)]
    for found, call, (p, c, mass, now, state) in zip(student.moment.many(calls), calls, cases, strict=True):
        force = mass * derivative(derivative(p))
        expect(
            found,
            value(cross(difference(p, c), force), now),
            within=POINTWISE,
            scale=size(state, mass)[0],
            of="the moment",
            unit="of its size",
            kind=call.kind,
            at=call,
            hint="the lever arm runs from C to P, and the force on P is all of its m a",
        )


def momentum_variant(says, velocity, arm=lambda r_p, r_c: r_p - r_c):
    """With velocity(definition, v_p, v_c) in place of the right one."""

    def wrong(definition, r_p, v_p, r_c, v_c, mass):
        return np.cross(arm(r_p, r_c), mass * velocity(definition, v_p, v_c))

    return suspect(says, angular_momentum=wrong)


MOMENTUM_SUSPECTS = [
    momentum_variant("the other definition: are b and c swapped?", lambda d, v_p, v_c: v_p - v_c if d == "b" else v_p),
    momentum_variant("the velocity of C for that of P", lambda d, v_p, v_c: v_c),
    momentum_variant(
        "the angular momentum about O in place of C",
        lambda d, v_p, v_c: v_p - v_c if d == "c" else v_p,
        lambda r_p, r_c: r_p,
    ),
]
TURNED_ROUND = momentum_variant(
    "v_{C/P} for v_{P/C}: the sign of the relative velocity reversed",
    lambda d, v_p, v_c: v_c - v_p if d == "c" else v_p,
)
IN_EVERY = momentum_variant("the velocity relative to C in every definition", lambda d, v_p, v_c: v_p - v_c)
IN_A = momentum_variant(
    "the velocity relative to C in definition a, whose C' does not move",
    lambda d, v_p, v_c: v_p - v_c if d == "a" else v_p,
)


def judge_momentum(student, draw, definitions, hint):
    """All definitions are asked for before any is judged: a suspect tells a mistake in one from that in every."""
    cases = [(definition, *case) for definition in definitions for case in motions(draw)]
    calls = [
        given(definition, s[0], s[1], s[3], s[4], mass=mass).on(kind_of(s, f"definition {definition}"))
        for definition, _, _, mass, _, s in cases
    ]
    found = student.angular_momentum.many(calls)
    for one, call, (definition, p, c, mass, now, state) in zip(found, calls, cases, strict=True):
        expect(
            one,
            value(momentum(definition, p, c, mass, now), now),
            within=POINTWISE,
            scale=size(state, mass)[1] or 1.0,
            of="the angular momentum",
            unit="of its size",
            kind=call.kind,
            hint=hint,
            at=call,
        )


@check(points=1, part="a", suspects=[*MOMENTUM_SUSPECTS, IN_EVERY, IN_A])
def momentum_with_the_velocity_in_F(student, draw):
    """angular_momentum by definitions a and b: the lever arm from C, the velocity as F sees it."""
    judge_momentum(student, draw, "ab", "at one instant, can definitions a and b differ?")


@check(points=0.75, part="a", suspects=[*MOMENTUM_SUSPECTS, TURNED_ROUND])
def momentum_with_the_velocity_relative_to_C(student, draw):
    """angular_momentum by definition c: the velocity as one sees it who moves along with C."""
    judge_momentum(student, draw, "c", "whose velocity, seen from where?")


LETTERS_ALIKE = ("A", "C", " b", "abc")  # no definitions, though they hold a letter of one


def refuses_others(student, draw, name):
    """The function refuses letters that name no definition."""
    _, _, mass, _, state = motions(draw)[0]
    arguments = state if name != "angular_momentum" else (*state[:2], *state[3:5])
    for definition in ("d", "ab", "", *LETTERS_ALIKE):
        expect_that(
            getattr(student, name).refuses(definition, *arguments, mass=mass),
            f"{name} takes a definition that there is none of",
            at=definition,
            hint="raise ValueError for anything but the three letters",
        )


@check(points=0.25, part="a", after=(momentum_with_the_velocity_in_F, momentum_with_the_velocity_relative_to_C))
def momentum_refuses_other_definitions(student, draw):
    """angular_momentum raises ValueError for another definition."""
    refuses_others(student, draw, "angular_momentum")


def terms(state, mass):
    """The moment, and the terms by which the rates of b and of c differ from it."""
    r_p, v_p, a_p, r_c, v_c, a_c = state
    r = r_p - r_c
    return np.cross(r, mass * a_p), -np.cross(v_c, mass * v_p), -np.cross(r, mass * a_c)


def rate_variant(says, by):
    """With by[definition](moment, b's term, c's term) for the discrepancy."""

    def discrepancy(definition, *state, mass):
        return by[definition](*terms(state, mass))

    def rate(definition, *state, mass):
        return terms(state, mass)[0] + by[definition](*terms(state, mass))

    return suspect(says, rate=rate, discrepancy=discrepancy)


def nothing(moment, b, c):
    return np.zeros(3)


RIGHT = {"a": nothing, "b": lambda moment, b, c: b, "c": lambda moment, b, c: c}
SWAPPED = rate_variant("the other definition: are b and c swapped?", {**RIGHT, "b": RIGHT["c"], "c": RIGHT["b"]})
OF_UNIT_MASS = suspect(
    "the discrepancy without the mass",
    discrepancy=lambda definition, *state, mass: RIGHT[definition](*terms(state, 1.0)),
    rate=lambda definition, *state, mass: terms(state, mass)[0] + RIGHT[definition](*terms(state, 1.0)),
)
A_SUSPECTS = [
    rate_variant("the rate of definition b: a point C' that moves", {**RIGHT, "a": RIGHT["b"]}),
    rate_variant("the rate of definition c: velocities relative to C", {**RIGHT, "a": RIGHT["c"]}),
]
B_SUSPECTS = [
    SWAPPED,
    rate_variant("the moment for the rate: in definition b, C moves while time goes on", {**RIGHT, "b": nothing}),
    rate_variant("the sign of the velocity of C's term reversed", {**RIGHT, "b": lambda moment, b, c: -b}),
    OF_UNIT_MASS,
]
C_SUSPECTS = [
    SWAPPED,
    rate_variant("the moment for the rate: the acceleration of C forgotten", {**RIGHT, "c": nothing}),
    rate_variant("the sign of the acceleration of C reversed", {**RIGHT, "c": lambda moment, b, c: -c}),
    rate_variant("the term of definition b in definition c too", {**RIGHT, "c": lambda moment, b, c: b + c}),
    OF_UNIT_MASS,
]


def judge_rate(student, draw, name, definition, hint=""):
    """Compare the rate, or the rate less the moment, with the derivative of the polynomials."""
    cases = motions(draw)
    calls = [
        given(definition, *state, mass=mass).on(kind_of(state, f"definition {definition}"))
        for _, _, mass, _, state in cases
    ]
    results = getattr(student, name).many(calls)
    for found, call, (p, c, mass, now, state) in zip(results, calls, cases, strict=True):
        expected = derivative(momentum(definition, p, c, mass, now))
        if name == "discrepancy":
            expected = difference(expected, mass * cross(difference(p, c), derivative(derivative(p))))
        scale = size(state, mass)[0] or 1.0
        look = (
            partial(discrepancy_hint, results, cases, definition)
            if name == "discrepancy"
            else partial(rate_hint, found, value(expected, now), scale, hint)
        )
        expect(
            found,
            value(expected, now),
            within=POINTWISE,
            scale=scale,
            of=f"the {name}",
            unit="of a moment's size",
            kind=call.kind,
            hint=look,
            at=call,
        )


def rate_hint(found, expected, scale, hint):
    """What to say of a rate that is nearly right, as a difference quotient is."""
    if np.abs(found - expected).max() <= NEARLY * scale:
        return "it is nearly right: is it a difference quotient? Differentiate the product on paper"
    return hint


LEFT = "it is your rate less your moment: what is left of it on paper?"


def discrepancy_hint(results, cases, definition):
    """What to say of discrepancies that, but for rounding, all vanish or are all of the opposite sign."""
    scales = [size(state, mass)[0] or 1.0 for _, _, mass, _, state in cases]
    rights = [RIGHT[definition](*terms(state, mass)) for _, _, mass, _, state in cases]

    def all_are(factor):
        errors = (np.abs(found - factor * one).max() for found, one in zip(results, rights, strict=True))
        return all(error <= POINTWISE * scale for error, scale in zip(errors, scales, strict=True))

    if definition == "a":
        return FIXED
    if all_are(-1):
        return "it is moment less rate: the sign is reversed"
    if all_are(0):
        return "it vanishes for every motion: is your rate the moment itself? the motion of C is forgotten"
    return LEFT


FIXED = "C' stays where C is at this instant: what is its velocity?"
PRODUCT = "differentiate the product: which vectors change with time?"


@check(points=0.5, part="a", suspects=A_SUSPECTS)
def rate_about_a_fixed_point(student, draw):
    """rate by definition a: the derivative while C' stays where it is."""
    judge_rate(student, draw, "rate", "a", FIXED)


@check(points=1, part="a", suspects=B_SUSPECTS)
def rate_with_the_velocity_in_F(student, draw):
    """rate by definition b: the derivative of its angular momentum along any motion of P and C."""
    judge_rate(student, draw, "rate", "b", PRODUCT)


@check(points=0.75, part="a", suspects=C_SUSPECTS)
def rate_with_the_velocity_relative_to_C(student, draw):
    """rate by definition c: the derivative of its angular momentum along any motion of P and C."""
    judge_rate(student, draw, "rate", "c", PRODUCT)


@check(points=0.25, part="a", after=(rate_about_a_fixed_point, rate_with_the_velocity_in_F))
def rate_refuses_other_definitions(student, draw):
    """rate raises ValueError for another definition."""
    refuses_others(student, draw, "rate")


@check(points=0.5, part="a", suspects=B_SUSPECTS)
def discrepancy_with_the_velocity_in_F(student, draw):
    """discrepancy by definition b: its rate less the moment."""
    judge_rate(student, draw, "discrepancy", "b")


@check(points=0.5, part="a", suspects=C_SUSPECTS)
def discrepancy_with_the_velocity_relative_to_C(student, draw):
    """discrepancy by definition c: its rate less the moment."""
    judge_rate(student, draw, "discrepancy", "c")


@check(points=0.25, part="a", after=discrepancy_with_the_velocity_in_F, suspects=A_SUSPECTS)
def no_discrepancy_about_a_fixed_point(student, draw):
    """discrepancy by definition a."""
    judge_rate(student, draw, "discrepancy", "a")


@check(points=0.25, part="a", after=discrepancy_with_the_velocity_in_F)
def discrepancy_refuses_other_definitions(student, draw):
    """discrepancy raises ValueError for another definition."""
    refuses_others(student, draw, "discrepancy")


GRID = np.linspace(0, 1, 2001)


def smallest(p):
    """Smallest magnitude of a vector of polynomials for 0 <= t <= 1, and where: by thirds about each dip of a grid."""

    def magnitude(t):
        return np.linalg.norm(value(p, t), axis=-1)

    known = np.pad(magnitude(GRID), 1, constant_values=np.inf)
    dips = np.flatnonzero((known[1:-1] < known[2:]) & (known[1:-1] <= known[:-2]))
    low, high = GRID[np.maximum(dips - 1, 0)], GRID[np.minimum(dips + 1, len(GRID) - 1)]
    for _ in range(80):  # 1e-17
        a, b = low + (high - low) / 3, high - (high - low) / 3
        left = magnitude(a) < magnitude(b)
        low, high = np.where(left, low, a), np.where(left, b, high)
    times = np.append([0.0, 1.0], (low + high) / 2)
    where = np.argmin(magnitude(times))
    return magnitude(times)[where], times[where]


def extent(p):
    """What a vector of polynomials cannot exceed for 0 <= t <= 1."""
    return np.abs(p).sum()


def violation(definition, p, c):
    """The product that vanishes at every t if the definition holds, its size, and that of what it is rounded from."""
    if definition == "b":  # -v_C x m v_P
        one, other = derivative(c), derivative(p)
        rounded = extent(one) * extent(other)
    else:  # -r_{P/C} x m a_C
        one, other = difference(p, c), derivative(derivative(c))
        rounded = (extent(p) + extent(c)) * extent(other)
    return np.abs(cross(one, other)).max(), extent(one) * extent(other), rounded


def holds(definition, p, c):
    """Whether rate = moment at every t: all coefficients of the violation are zero, but for rounding."""
    worst, whole, rounded = violation(definition, p, c)
    return worst <= min(IDENTITY * rounded, FAR_OFF * whole)


def fails(definition, p, c):
    """Whether rate and moment differ at some t for certain."""
    worst, whole, rounded = violation(definition, p, c)
    return worst > max(CERTAIN * whole, IDENTITY * rounded)


def flaws(definition, p, c):
    """What is wrong with a motion for which this definition should hold and the other fail; each flaw with a hint."""
    if max(len(p), len(c)) > LONGEST:
        yield f"the motion has more than {LONGEST} coefficients", ""
    apart, speed = difference(p, c), derivative(c)
    still, rounded = NOTHING * extent(speed), IDENTITY * (extent(p) + extent(c))
    for vector, limit, what in (
        (speed, still, "the velocity of C vanishes"),
        (derivative(speed), still, "the acceleration of C vanishes"),
        (apart, max(NOTHING * extent(apart), rounded), "P and C meet"),
    ):
        least, when = smallest(vector)
        if not least > limit:
            yield f"{what} at t = {when:.2g}", ""
    if not extent(apart[1:]) > max(CERTAIN * extent(speed), rounded):
        yield "P moves along with C: the vector between them does not change", ""
    other = {"b": "c", "c": "b"}[definition]
    if not holds(definition, p, c):
        worst, whole, _ = violation(definition, p, c)
        swapped = f"they do not by definition {other}" if holds(other, p, c) else ""
        hint = swapped or "which product must vanish, and at every t? Multiply the polynomials out"
        yield f"rate and moment differ by {worst / (whole or 1.0):.1e} of their size", hint
    if not fails(other, p, c):
        yield f"definition {other} has rate = moment, too, along the motion", ""


def judge_motion(definition, p, c):
    """The motion must have no flaw; if it has none in another order, the student is told."""
    for says, hint in flaws(definition, p, c):
        found = order_hint(definition, p, c) or hint
        expect_that(False, says, kind=f"definition {definition}", at=(p, c), hint=found)


def order_hint(definition, p, c):
    """What to say of a motion that has no flaw with P and C exchanged, or with its coefficients turned round.

    While P rests, definition b holds whatever C does: then only a highest coefficient of zero tells that they are.
    """
    orders = {"are P and C swapped? the motion of P comes first": (c, p)}
    if definition == "c" or np.any(p[:-1]) or not np.any(c[-1]):
        orders["the sum starts at j = 0: p[0] and c[0] are the positions at t = 0"] = (p[::-1], c[::-1])
    return next((says for says, pair in orders.items() if next(flaws(definition, *pair), None) is None), "")


@check(points=1.5, part="a")
def special_motion_of_b(student, draw):
    """special_motion of b: a motion with C speeding, for which definition b holds at every t, and c does not."""
    judge_motion("b", *student.special_motion("b"))


@check(points=1.25, part="a")
def special_motion_of_c(student, draw):
    """special_motion of c: a motion with C speeding, for which definition c holds at every t, and b does not."""
    judge_motion("c", *student.special_motion("c"))


@check(points=0.25, part="a", after=(special_motion_of_b, special_motion_of_c))
def special_motion_refuses_other_definitions(student, draw):
    """special_motion raises ValueError for another definition."""
    for definition in ("d", "bc", "", "a", *LETTERS_ALIKE):
        says = "gives a motion for definition a" if definition == "a" else "takes a definition that there is none of"
        expect_that(
            student.special_motion.refuses(definition),
            f"special_motion {says}",
            at=definition,
            hint='raise ValueError for anything but "b" and "c"',
        )
