"""Hidden checks of hw12."""

import math

import numpy as np

from tam570_grader import (
    Column,
    Invariant,
    agree,
    array,
    check,
    expect,
    follow,
    formula,
    from_own_lagrangian,
    number,
    rows,
    stays,
)

from . import cases, right

RESULTS = {
    "lagrangian": formula("x", "v", "m", "c", "g"),
    "lagrange_equation": formula("x", "v", "c", "g"),
    "acceleration_newton": number,
    "constraint_force": array(2),
    "energy": number,
    "simulate": rows(2),
    "period": number,
}
NEEDS = ("numpy", "sympy")
OFF_LIMITS = {"*": ("tam570.lagrange", "tam570.lectures")}

FORMULA = 1e-8  # a few roundings make 1e-15, a derivative by central differences 1e-10
FEW_DIGITS = 1e-4  # of x'' next to the bottom; differences of energies are good to 5e-6 of what is nearly zero
TRAJECTORY = 2e-5  # LSODA at rtol 1e-9, atol 1e-9 is off by 1e-6 after three periods, RK45 and DOP853 by less
SHARP_TURN = 2e-4  # ... by 1e-5 behind the sharp turns of a steep wire
ENERGY = 7e-5  # BDF at the same tolerances loses 7e-6 of it in thirty periods, the others 1e-6
COARSELY = 0.1  # of the amplitude after thirty periods; rows from anywhere on the motion are off by one or two
PERIOD = 1e-6  # a quadrature with a singular end, or an event of a simulation, is good to 1e-8
TINY = 5e-4  # at micrometres an event of a simulation with an absolute tolerance of 1e-9 m is good to 5e-5


def largest_term(case, found):
    """x'', or what cancels in it."""
    values = dict(zip(("x", "v"), case.args, strict=False)) | {k[0]: value for k, value in case.kwargs.items()}
    return abs(found) or values["g"] + values["c"] * values["v"] ** 2


def kinetic_and_potential(x, v, m, c, g):
    return right.energy(x, v, m, c, g) or 1.0


ACCELERATION = {"of": "x''", "unit": "m/s^2", "scale": largest_term}


@check(points=1, part="a")
def lagrangian_is_kinetic_less_potential(student, draw):
    """lagrangian: T - V in x, v, m, c, g, V up to a constant."""
    calls = cases.symbols(cases.beads(draw))
    levels = student.lagrangian.at([{**case.kwargs, "x": 0.0, "v": 0.0} for case in calls])
    for level, (case, value) in zip(levels, student.lagrangian.each(calls), strict=True):
        within = FORMULA * kinetic_and_potential(**case.kwargs)
        hint = "How fast is the bead along the wire when x changes at the rate v?"
        expected = right.lagrangian(**case.kwargs)
        expect(value - level, expected, within=within, of="the Lagrangian", unit="J", hint=hint)


@check(points=1.5, part="a")
def lagrange_gives_the_acceleration(student, draw):
    """lagrange_equation: x'' in x, v, c, g alone."""
    calls = cases.beads(draw)
    equation, random = student.lagrange_equation, cases.symbols(calls[:5])

    def hint(*_):
        wrong = "dT/dv depends on x, so its rate has a term with v; and dT/dx is not zero."
        return from_own_lagrangian(equation, student.lagrangian, random, "x", "v") or wrong

    known = {**ACCELERATION, "hint": hint}
    agree(equation, right.lagrange_equation, cases.symbols(calls, "m"), within=FORMULA, **known)
    close = cases.symbols(cases.next_to_bottom(calls[0]), "m")
    agree(equation, right.lagrange_equation, close, within=FEW_DIGITS, **known)


@check(points=1.5, part="b")
def newton_gives_the_acceleration(student, draw):
    """acceleration_newton: x'' by F = m a along the tangent, as Lagrange has it."""
    calls = cases.massless(cases.beads(draw))
    known = {**ACCELERATION, "hint": "Differentiate y = c x^2 twice: y'' has two terms."}
    agree(student.acceleration_newton, right.acceleration, calls, within=FORMULA, **known)
    close = cases.next_to_bottom(calls[0])
    agree(student.acceleration_newton, right.acceleration, close, within=FEW_DIGITS, **known)


def forces(draw):
    calls = cases.beads(draw)
    return calls + cases.next_to_bottom(calls[0])


@check(points=0.75, part="b")
def force_has_the_right_size(student, draw):
    """constraint_force: as large as carrying and turning the bead takes."""
    for case, force in student.constraint_force.each(forces(draw)):
        size = math.hypot(*right.force(*case.args, **case.kwargs))
        hint = "What force does a bead need at the bottom, at rest and passing by?"
        within = FORMULA * (size or 1.0)
        expect(math.hypot(*force), size, within=within, of="the size of the force", unit="N", hint=hint)


@check(points=0.5, part="b", after=force_has_the_right_size)
def force_and_weight_make_the_acceleration(student, draw):
    """constraint_force: normal to the wire, and with the weight it is m a."""
    hint = "Dot it with the tangent (1, 2 c x): is that zero? Does the force act on the bead?"
    known = {"of": "the force", "unit": "N", "scale": lambda _, force: math.hypot(*force), "hint": hint}
    agree(student.constraint_force, right.force, forces(draw), within=FORMULA, **known)


@check(points=1, part="b")
def energy_is_kinetic_and_potential(student, draw):
    """energy: of the speed along the wire and of the height above the bottom."""
    calls = forces(draw)
    calls.append(cases.nearly_at_rest(calls[0]))
    hint = "v is not the speed along the wire."
    agree(student.energy, right.energy, calls, within=FORMULA, of="the energy", unit="J", hint=hint)


def size(case, states):
    """The amplitude; without gravity the farthest place."""
    _, x, v = case.args
    return right.amplitude(x, v, **case.kwargs) if case.kwargs["gravity"] else np.max(np.abs(states[:, 0]))


def pace(case, states):
    rate = math.sqrt(2 * case.kwargs["gravity"] * case.kwargs["curvature"])
    return size(case, states) * rate or np.max(np.abs(states[:, 1]))


MOTION = (Column("x", "m", [0], scale=size), Column("v", "m/s", [1], scale=pace))
KEPT = Invariant(
    "the energy",
    "of itself",
    right.energy_of_rows,
    lambda case, states: right.energy_of_rows(states[:1], **case.kwargs)[0],
    ENERGY,
)


@check(points=1, part="b")
def simulate_slides(student, draw):
    """simulate: large motions, row i at t[i], row 0 the given state."""
    calls = [cases.ride(draw, 0.4, 1.0, 1000, 15.0, "an amplitude near 1/c")]
    hint = "Is v the rate of x, and x'' that of part (a)?"
    follow(student.simulate, right.motion, calls, MOTION, within=TRAJECTORY, hint=hint, keeps=KEPT)


@check(points=0.5, part="b", after=simulate_slides)
def simulate_needs_no_dense_times(student, draw):
    """simulate: the same motion when only a few times are asked for."""
    hint = "Your own steps are not those of t: is the tolerance tight?"
    follow(student.simulate, right.motion, cases.few_times(draw), MOTION, within=TRAJECTORY, hint=hint)
    small = "However small the amplitude, the other terms are there."
    follow(student.simulate, right.motion, [cases.close(draw)], MOTION, within=TRAJECTORY, hint=small, loose=False)


@check(points=0.25, part="b", after=simulate_slides)
def simulate_without_gravity(student, draw):
    """simulate: without gravity the bead goes along the wire at its speed, whatever was asked for before."""
    hint = "Is anything divided by gravity?"
    follow(student.simulate, right.motion, cases.weightless(draw), MOTION, within=TRAJECTORY, hint=hint)


@check(points=0.25, part="b", after=simulate_slides)
def simulate_slides_down_steep_wires(student, draw):
    """simulate: an amplitude of many 1/c, where the bead turns sharply at the bottom."""
    calls = [cases.ride(draw, 5.0, 8.0, 60, 60.0, "an amplitude of several 1/c")]
    hint = "Are the steps short enough for the sharp turn at the bottom?"
    follow(student.simulate, right.motion, calls, MOTION, within=SHARP_TURN, hint=hint)


@check(points=0.25, part="b", after=simulate_slides)
def simulate_keeps_the_energy(student, draw):
    """simulate: the energy stays what it was over many periods."""
    calls = [cases.ride(draw, 0.4, 1.0, 300, 180.0, "many periods")]
    share = {1e-3: 0.6, 1e-2: 0.3}
    hint = "Do your steps grow with the duration?"
    stays(student.simulate, right.motion, calls, KEPT, MOTION, coarsely=COARSELY, partial=share, hint=hint)


@check(points=1, part="b")
def period_is_exact(student, draw):
    """period: exact for amplitudes near 1/c."""
    calls = cases.periods(draw, draw.uniform(0.2, 0.6, 8), "an amplitude near 1/c")
    hint = "The energy gives v at every x, and dt = dx/v."
    agree(student.period, right.period, calls, within=PERIOD, of="the period", unit="s", hint=hint)


TINY_AMPLITUDES = "Do you add a small number under a root, or use an absolute tolerance? 1e-15 m^2 is not small here."


@check(points=0.5, part="b", after=period_is_exact)
def period_of_small_and_of_huge_amplitudes(student, draw):
    """period: exact where the wire is almost flat and where it is almost upright."""
    tiny = cases.periods(draw, np.full(2, 1e-5), "an amplitude of a hundred-thousandth of 1/c", decades=(0.5, 1))
    small = cases.periods(draw, 10 ** draw.uniform(-3, -2, 3), "an amplitude of some thousandths of 1/c")
    huge = cases.periods(draw, np.append(10 ** draw.uniform(1, 2, 3), 100.0), "an amplitude of many 1/c")
    for calls, within, hint in (
        (tiny, TINY, TINY_AMPLITUDES),
        (small, PERIOD, "Do you subtract nearly equal heights?"),
        (huge, PERIOD, "Does your series or quadrature reach amplitudes of a hundred times 1/c?"),
    ):
        agree(student.period, right.period, calls, within=within, of="the period", unit="s", hint=hint)
