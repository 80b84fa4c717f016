"""Hidden checks of hw10. What is right comes from H' = 0 in vectors, elliptic functions, and a wheel's two turns."""

import math
from dataclasses import replace
from functools import partial

import numpy as np
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk, ellipkinc, elliprf

from tam570_grader import (
    array,
    check,
    distances,
    drawing,
    expect,
    expect_that,
    given,
    group,
    judge_axes_of_lengths,
    judge_boxes,
    mistimed,
    number,
    once,
    rows,
    suspect,
    words,
)
from tam570_grader.writing.curves import along

RESULTS = {
    "euler_equations": array(3),
    "attitude_rate": array(3, 3),
    "euler_rates_313": array(3),
    "energy": number,
    "angular_momentum": array(3),
    "simulate": group(rows(3), rows(3, 3)),
    "symmetric_solution": rows(3),
    "wobble_rate": number,
    "growth_rate_squared": number,
    "tumble_period": array(infinite=True),
    "wireframe": array(12, 2, 3),
    "plot_rim_paths": drawing,
}
NEEDS = ("numpy", "matplotlib.figure")
OFF_LIMITS = {"*": ("tam570.lectures",), "euler_rates_313": ("tam570.rotations", "scipy.spatial.transform")}
MANUAL = {
    "a": (2, "a simple explanation of the two tilted circles"),
    "b": (2, "the prediction for (0, 1, eps), made before looking, and the plot that shows the instability"),
}

POINTWISE = 1e-8  # a few roundings make 1e-15; a derivative by central differences, 1e-9
SINGULAR = 1e-2  # a pseudoinverse where a singular value is 1e-12 makes 1e-4; a sine kept from zero, 0.3
# solve_ivp at rtol 1e-9, atol 1e-9 is off by 6e-8 at the most (LSODA), an explicit method of order 2 at a thousand
# steps a radian by 1e-6; at its own tolerances solve_ivp is off by 2e-5.
TRAJECTORY = 3e-6
# The same solvers lose 7e-8 of R^T R = I in 45 radians; with order 2 the energy may swing by 1e-6.
INVARIANT = 1e-5
PERIOD = 1e-6  # a period measured on a simulation is good to 1e-8
# 1 - k^2 is 1e-9 there: as a difference it has 7 digits; events of solve_ivp at 1e-9 are off by 4e-6 (LSODA)
NEAR_PERIOD = 1e-4


# The motion in vectors


def moving(omega, *, inertia):
    """omega', from H' = 0: the rate of H in the body's axes is H x omega."""
    inertia = np.asarray(inertia)
    return np.cross(inertia * omega, omega) / inertia


def hat(omega):
    """The matrix of omega x."""
    return np.cross(omega, np.eye(3)).T


def turned(v):
    """The rotation by |v| about v."""
    angle = np.linalg.norm(v)
    n = v / angle if angle else v
    return np.cos(angle) * np.eye(3) + 2 * math.sin(angle / 2) ** 2 * np.outer(n, n) + math.sin(angle) * hat(n)


def right_attitude(R, omega):
    """Every row of R, an axis of space seen from the body, turns backwards."""
    return np.cross(R, omega)


PRECISE = {"method": "DOP853", "rtol": 1e-11, "atol": 1e-11}


def motion(t, R, omega, *, inertia, euler=moving, attitude=right_attitude, solver=PRECISE):
    """omegas and rotations by solve_ivp, or NaN where there is no such motion."""

    def rates(_, y):
        return np.concatenate([euler(y[:3], inertia=inertia), attitude(y[3:].reshape(3, 3), y[:3]).ravel()])

    start = np.concatenate([omega, np.ravel(R)])
    found = solve_ivp(rates, (t[0], t[-1]), start, t_eval=t, **solver)
    states = found.y.T if found.success else np.full((len(t), 12), np.nan)
    return states[:, :3], states[:, 3:].reshape(-1, 3, 3)


def elliptic(t, omega, inertia):
    """omega at the times t in Jacobi's elliptic functions, for any three different inertias."""
    order = np.argsort(inertia)
    (A, B, C), w = inertia[order], omega[order]
    double, square = 2 * energy(omega, inertia=inertia), np.sum((inertia * omega) ** 2)
    outward = slice(None, None, 1 if square > double * B else -1)  # ends with the axis that omega goes round
    (A, B, C), w = inertia[order][outward], w[outward]
    beside, along = double * C - square, square - double * A
    amplitudes = np.sqrt([beside / (A * (C - A)), beside / (B * (C - B)), along / (C * (C - A))])
    m, rate = (B - A) * beside / ((C - B) * along), math.sqrt((C - B) * along / (A * B * C))
    sign = math.copysign(1.0, w[2])
    handedness = np.linalg.det(np.eye(3)[order])  # axes in a left-handed order see the motion backwards
    start = ellipkinc(math.atan2(sign * w[1] / amplitudes[1], w[0] / amplitudes[0]), m)
    sn, cn, dn, _ = ellipj(start + handedness * rate * (t - t[0]), m)
    found = np.column_stack([cn, sign * sn, sign * dn]) * amplitudes
    return found[:, outward][:, np.argsort(order)]


def energy(omega, *, inertia):
    return 0.5 * np.sum(inertia * omega**2)


def wheel(t, R, omega, inertia):
    """omegas and rotations of a body with A = B: its wobble about H in space, its slip about its own axis."""
    A, _, C = inertia
    H, slip = R @ (inertia * omega), np.array([0.0, 0.0, (1 - C / A) * omega[2]])
    omegas = [turned(-slip * tau) @ omega for tau in t - t[0]]
    return np.array(omegas), np.array([turned(H / A * tau) @ R @ turned(slip * tau) for tau in t - t[0]])


# The draws


def a_body(draw):
    """Inertias in any order, each less than the sum of the other two, of any size."""
    spread = draw.permutation([draw.uniform(0.1, 0.25), draw.uniform(0.4, 0.6), draw.uniform(0.8, 1)])
    return (spread.sum() - spread) * 10 ** draw.uniform(-2, 2)


def a_wheel(draw):
    """A = B, and C from a rod's to that of a disk."""
    A = 10 ** draw.uniform(-2, 2)
    return np.array([A, A, A * draw.choice([draw.uniform(0.2, 0.7), draw.uniform(1.3, 1.9)])])


def near_wheels(draw):
    """Each two of the inertias, once, differ by less than isclose and allclose see."""
    for shift in range(3):
        other = draw.choice([draw.uniform(0.5, 0.8), draw.uniform(1.3, 1.8)])
        yield np.roll([1.0, 1.0 + draw.choice([-1, 1]) * draw.uniform(2e-6, 8e-6), other], shift)


def an_omega(draw):
    """No component is small, and the size is between .5 and 6 rad/s."""
    return draw.uniform(0.4, 1, 3) * draw.choice([-1, 1], 3) * 10 ** draw.uniform(0, 0.5)


def a_fast_omega(draw):
    """At 15 to 18 rad/s: steps of a millisecond follow it, those of ten do not."""
    omega = an_omega(draw)
    return omega * draw.uniform(15, 18) / np.linalg.norm(omega)


OMEGAS = ("omega zero", "omega along a principal axis", "omega in a principal plane", "omega of one sign")


def omega_kind(omega):
    """What an omega of `plain_omegas` is called."""
    return OMEGAS[np.count_nonzero(omega)]


def plain_omegas(draw):
    """Spins about each axis both ways, omegas with one zero, without one but of one sign, and none."""
    size = np.abs(an_omega(draw))
    return [sign * size * some + 0.0 for some in np.ndindex(2, 2, 2) for sign in (1, -1)]  # no zero has a sign


def plain_attitudes(draw):
    """The body's axes along those of space: as they are, and after a quarter turn and a half turn."""
    axis = draw.permutation(np.eye(3))[0]
    return [np.eye(3), *(np.round(turned(angle * axis)) + 0.0 for angle in (math.pi / 2, math.pi))]


ATTITUDES = ("R = I", "R of a quarter turn", "R of a half turn", "a random R")


def named_attitudes(draw):
    """`plain_attitudes` and what they are called."""
    return list(zip(plain_attitudes(draw), ATTITUDES, strict=False))


def an_attitude(draw):
    return turned(draw.uniform(0.4, 1.2, 3) * draw.choice([-1, 1], 3))


def times(draw, omega, radians, count=25, start=None):
    """Uneven times, from this start or any that is not 0, for so many radians."""
    span = radians / np.linalg.norm(omega)
    inner = np.sort(draw.uniform(0.02, 0.98, count - 2))
    start = draw.uniform(-3, 3) if start is None else start
    return start + span * np.concatenate([[0.0], inner, [1.0]])


def starts(draw, count):
    """Some before t = 0 and some after, as the first is: what starts at t = 0 gives one result there."""
    return np.resize([1, -1], count) * draw.uniform(0.5, 3, count)


def sorted_body(draw):
    return np.sort(a_body(draw))


# Pointwise


def judge(function, calls, right, *, of, kind="", size=None, within=POINTWISE, unit="of itself", hint=""):
    """Compare with right(...) of the same arguments, relative to size(...) of them or to the size of what is right."""
    calls = [call.on(call.kind or kind) for call in calls]
    for found, call in zip(function.many(calls), calls, strict=True):
        expect_that(np.all(np.isfinite(found)), f"{of} is infinite", kind=call.kind, hint=hint, at=call)
        expected = right(*call.args, **call.kwargs)
        scale = size(*call.args, **call.kwargs) if size else np.linalg.norm(expected)
        expect(found, expected, within=within, scale=scale or 1.0, unit=unit, at=call, of=of, kind=call.kind, hint=hint)


def signs_changed(*signs):
    return lambda omega, *, inertia: moving(omega, inertia=inertia) * signs


THIRD_IS_ZERO = "A = B put into the third of Euler's equations: omega_3 stays"


@check(
    points=0.75,
    part="a",
    suspects=[
        suspect("every sign in Euler's equations changed", euler_equations=signs_changed(-1, -1, -1)),
        suspect("a sign changed in the first of Euler's equations", euler_equations=signs_changed(-1, 1, 1)),
        suspect("a sign changed in the second of Euler's equations", euler_equations=signs_changed(1, -1, 1)),
        suspect("a sign changed in the third of Euler's equations", euler_equations=signs_changed(1, 1, -1)),
        suspect(
            "the moments H x omega not divided by A, B, C",
            euler_equations=lambda w, *, inertia: np.cross(inertia * w, w),
        ),
        suspect(THIRD_IS_ZERO, euler_equations=signs_changed(1, 1, 0)),
    ],
)
def euler_equations_keep_the_angular_momentum(student, draw):
    """euler_equations: omega' of a body without moments, for any three inertias, equal ones too."""
    # H is along omega to the last digit where all are A
    A, k = 2.0 ** draw.integers(-1, 2), draw.uniform(0.5, 2)
    bodies = [(a_body(draw), "a random body and omega") for _ in range(12)]
    bodies += [(a_wheel(draw), "a body with A = B") for _ in range(4)]
    bodies += [(np.array([A, A, A]), "three equal inertias"), (np.array([k * A, A, A]), "a body with B = C")]
    bodies += [(body, "two inertias that are equal to five digits, no more") for body in near_wheels(draw)]
    judge(
        student.euler_equations,
        [given(an_omega(draw), inertia=body).on(kind) for body, kind in bodies],
        moving,
        size=lambda omega, inertia: omega @ omega,
        of="omega'",
        unit="of omega^2",
        hint="the rate of H in body components plus omega x H is zero",
    )
    plain = [
        given(omega, inertia=body).on(omega_kind(omega))
        for body in (a_body(draw), np.array([2.0, 1.0, 2.0]))
        for omega in plain_omegas(draw)
    ]
    judge(
        student.euler_equations,
        plain,
        moving,
        size=lambda omega, inertia: omega @ omega,
        of="omega'",
        unit="of omega^2",
        hint="which of the three products are zero?",
    )


@check(
    points=0.5,
    part="a",
    suspects=[
        suspect("omega-hat R for R omega-hat: omega is in body components", attitude_rate=lambda R, w: hat(w) @ R),
        suspect("the sign of omega-hat changed", attitude_rate=lambda R, w: -R @ hat(w)),
        suspect("the transpose of R in R omega-hat", attitude_rate=lambda R, w: R.T @ hat(w)),
        suspect("omega-hat alone, without R", attitude_rate=lambda R, w: hat(w)),
        suspect("the rate of the transpose", attitude_rate=lambda R, w: (R @ hat(w)).T),
    ],
)
def attitude_follows_omega(student, draw):
    """attitude_rate: dR/dt for omega in body components."""
    calls = [given(an_attitude(draw), an_omega(draw)) for _ in range(15)]
    judge(
        student.attitude_rate,
        calls,
        right_attitude,
        of="dR/dt",
        kind="a random attitude and omega",
        hint="the columns of R are the body's axes in space; each moves at omega x itself",
    )
    attitudes = [*named_attitudes(draw), (an_attitude(draw), ATTITUDES[-1])]
    plain = [
        given(R, omega).on(f"{omega_kind(omega)}, {kind}") for R, kind in attitudes for omega in plain_omegas(draw)
    ]
    judge(
        student.attitude_rate,
        plain,
        right_attitude,
        of="dR/dt",
        size=lambda R, omega: np.linalg.norm(omega),
        unit="of omega",
    )


@check(
    points=0.5,
    part="a",
    suspects=[
        suspect("an energy without the half", energy=lambda w, *, inertia: np.sum(inertia * w**2)),
        suspect(
            "the product of the lengths of H and omega: they have a scalar product",
            energy=lambda w, *, inertia: 0.5 * np.linalg.norm(inertia * w) * np.linalg.norm(w),
        ),
        suspect("the inertias squared", energy=lambda w, *, inertia: 0.5 * np.sum((w * inertia) ** 2)),
    ],
)
def energy_is_half_omega_h(student, draw):
    """energy: half of omega . H."""
    calls = [given(an_omega(draw), inertia=a_body(draw)) for _ in range(10)]
    judge(student.energy, calls, energy, of="the energy", kind="a random body and omega")
    wheels = [given(an_omega(draw), inertia=a_wheel(draw))]
    judge(student.energy, wheels, energy, of="the energy", kind="a body with A = B")
    plain = [given(omega, inertia=a_body(draw)).on(omega_kind(omega)) for omega in plain_omegas(draw)]
    judge(student.energy, plain, energy, of="the energy")


def momentum(R, omega, *, inertia):
    return np.sum([moment * w * axis for moment, w, axis in zip(inertia, omega, R.T, strict=True)], axis=0)


@check(
    points=0.5,
    part="a",
    suspects=[
        suspect("body components", angular_momentum=lambda R, w, *, inertia: inertia * w),
        suspect("R^T for R", angular_momentum=lambda R, w, *, inertia: R.T @ (inertia * w)),
        suspect(
            "R omega times A, B, C: the inertias belong to body axes",
            angular_momentum=lambda R, w, *, inertia: inertia * (R @ w),
        ),
    ],
)
def angular_momentum_is_in_space_axes(student, draw):
    """angular_momentum: the vector H in space components."""
    calls = [given(an_attitude(draw), an_omega(draw), inertia=a_body(draw)) for _ in range(10)]
    judge(student.angular_momentum, calls, momentum, of="H", kind="a random body, attitude and omega")
    wheels = [given(an_attitude(draw), an_omega(draw), inertia=a_wheel(draw))]
    judge(student.angular_momentum, wheels, momentum, of="H", kind="a body with A = B")
    plain = [
        given(R, omega, inertia=a_body(draw)).on(f"{omega_kind(omega)}, {kind}")
        for R, kind in named_attitudes(draw)
        for omega in plain_omegas(draw)
    ]
    judge(student.angular_momentum, plain, momentum, of="H")


def omega_of_rates(angles):
    """(3, 3): the columns are omega, in body components, of unit rates of psi, theta and phi."""
    _, theta, phi = angles
    x, z = np.eye(3)[[0, 2]]
    after_phi = turned(-phi * z)
    return np.column_stack([after_phi @ turned(-theta * x) @ z, after_phi @ x, z])


def rates_313(angles, omega):
    return np.linalg.solve(omega_of_rates(angles), omega)


def with_rate(which, wrong):
    """One of the rates wrong(angles, omega), the others right."""

    def rates(angles, omega):
        found = rates_313(angles, omega)
        found[which] = wrong(angles, omega)
        return found

    return rates


def rates_of_space_omega(angles, omega):
    """As if omega were in space components: R^T has the angles (-phi, -theta, -psi), and minus this omega."""
    psi, theta, phi = angles
    return rates_313([-phi, -theta, -psi], omega)[::-1]


def rates_of_positive_sine(angles, omega):
    """sin theta as a square root, never negative."""
    psi_rate, theta_rate, phi_rate = rates_313(angles, omega)
    sign = np.sign(math.sin(angles[1]))
    return np.array([sign * psi_rate, theta_rate, phi_rate + (1 - sign) * psi_rate * math.cos(angles[1])])


@check(
    points=0.75,
    part="a",
    suspects=[
        suspect("omega taken in space components", euler_rates_313=rates_of_space_omega),
        suspect("phi of the other sign", euler_rates_313=lambda angles, w: rates_313(angles * [1, 1, -1], w)),
        suspect(
            "the sign of omega_2 sin(phi) in theta' changed",
            euler_rates_313=with_rate(1, lambda angles, w: w[0] * math.cos(angles[2]) + w[1] * math.sin(angles[2])),
        ),
        suspect(
            "the sign of psi' cos(theta) in phi' changed",
            euler_rates_313=with_rate(2, lambda angles, w: w[2] + rates_313(angles, w)[0] * math.cos(angles[1])),
        ),
        suspect("psi and phi exchanged in the angles", euler_rates_313=lambda angles, w: rates_313(angles[::-1], w)),
        suspect("the rates in the order phi, theta, psi", euler_rates_313=lambda angles, w: rates_313(angles, w)[::-1]),
        suspect(
            "omega of these rates: the matrix for its inverse",
            euler_rates_313=lambda angles, rates: omega_of_rates(angles) @ rates,
        ),
    ],
)
def euler_rates_make_omega(student, draw):
    """euler_rates_313: the rates of psi, theta, phi that make this omega, for theta of any sign."""
    thetas = [*draw.uniform(0.3, 2.8, 6), *-draw.uniform(0.3, 2.8, 4), *draw.uniform(3.5, 5.9, 4)]
    kinds = ["theta from 0 to pi"] * 6 + ["a negative theta"] * 4 + ["theta from pi to 2 pi"] * 4
    calls = [
        given(np.array([psi, theta, phi]), an_omega(draw)).on(kind)
        for theta, psi, phi, kind in zip(thetas, *draw.uniform(-4, 4, (2, 14)), kinds, strict=True)
    ]
    judge_rates(student, calls)
    quarters = np.array([(0, 1, 0), (0, -1, 0), (1, 1, 0), (0, 1, 1), (2, -1, 1), (-1, 3, 2)]) * math.pi / 2
    plain = [
        given(angles, omega).on(f"theta a right angle, {omega_kind(omega)}")
        for angles in quarters
        for omega in plain_omegas(draw)
    ]
    judge_rates(student, plain)


PARTS = "omega is psi' along space z, theta' along the line of nodes, phi' along body z"


def judge_rates(student, calls):
    for found, call in zip(student.euler_rates_313.many(calls), calls, strict=True):
        angles, omega = call.args
        made = omega_of_rates(angles) @ found
        expect(
            made,
            omega,
            within=POINTWISE,
            scale=np.linalg.norm(omega) or 1.0,
            of="omega of the rates",
            unit="of omega",
            kind=call.kind,
            at=call,
            hint=partial(wrong_rates, found, angles, omega),
        )


def wrong_rates(found, angles, omega):
    """What is wrong with the rates, if it can be told."""
    rooted = np.allclose(found, rates_of_positive_sine(angles, omega), rtol=POINTWISE, atol=POINTWISE)
    return "sin theta is taken for positive: is it a square root?" if rooted else PARTS


UNDETERMINED = {"theta = 0": 0.0, "theta = pi": math.pi, "theta = -pi": -math.pi, "theta next to 0": 7e-13}


@check(points=0.25, part="a", after=euler_rates_make_omega)
def euler_rates_are_refused_where_undetermined(student, draw):
    """euler_rates_313 raises ValueError where abs(sin theta) < 1e-12, and nowhere else."""
    omega = an_omega(draw)
    # of omega's first two components half and more is psi' sin(theta): psi' is large next to sin theta = 0
    psi, phi = draw.uniform(-3, 3), math.atan2(omega[0], omega[1]) + draw.uniform(-1, 1)
    for kind, theta in UNDETERMINED.items():
        expect_that(
            student.on(kind).euler_rates_313.refuses(np.array([psi, theta, phi]), omega),
            "euler_rates_313 does not raise ValueError",
            kind=kind,
        )
    kind = "sin theta small, but not below 1e-12"
    for theta in (1.4e-12, -1.4e-12, 1e-8, math.pi - 1e-8):
        angles = np.array([psi, theta, phi])
        found, right = student.on(kind).euler_rates_313(angles, omega), rates_313(angles, omega)
        expect(
            found,
            right,
            within=SINGULAR,
            scale=np.abs(right).max(),
            of="a rate",
            unit="of the largest",
            kind=kind,
            at=(angles, omega),
            hint="which angles are refused? theta may be negative",
        )


# Motions


def side(omega, inertia):
    """Positive where omega goes round the axis of the largest inertia; in units of 2 B times the energy."""
    return np.sum((inertia * omega) ** 2) / (2 * energy(omega, inertia=inertia) * np.median(inertia)) - 1


def on_side(draw, sign):
    """A body and an omega well on one side of the separatrix."""
    while True:
        body, omega = a_body(draw), an_omega(draw)
        if sign * side(omega, body) > 0.05:
            return body, omega


@once
def tumbles(draw):
    """Calls on both sides of the separatrix and near it, and the right omegas."""
    near = draw.uniform(1, 3) * np.array([draw.uniform(0, 0.003), 1.0, draw.uniform(0.01, 0.02)])
    cases = [(*on_side(draw, 1), 14), (*on_side(draw, -1), 14), (sorted_body(draw), near, 25)]
    kinds = [
        f"omega {where}, t[0] not 0"
        for where in ("round the last axis", "round the first axis", "near the middle axis")
    ]
    calls = [
        given(times(draw, omega, radians, start=start), an_attitude(draw), omega, inertia=body).on(kind)
        for (body, omega, radians), kind, start in zip(cases, kinds, starts(draw, 3), strict=True)
    ]
    return calls, [elliptic(call.args[0], call.args[2], call.kwargs["inertia"]) for call in calls]


@once
def attitudes(draw):
    """Calls and the right rotations."""
    omegas = [an_omega(draw) for _ in range(2)]
    calls = [
        given(times(draw, omega, 12, start=start), an_attitude(draw), omega, inertia=a_body(draw)).on(
            "a general motion, t[0] not 0"
        )
        for omega, start in zip(omegas, starts(draw, 2), strict=True)
    ]
    return calls, [motion(*call.args, **call.kwargs)[1] for call in calls]


def wrong_motion(**equations):
    return lambda t, R, omega, *, inertia: motion(t, R, omega, inertia=inertia, **equations)


def from_identity(t, R, omega, *, inertia):
    return motion(t, np.eye(3), omega, inertia=inertia)


def in_space_components(t, R, omega, *, inertia):
    omegas, rotations = motion(t, R, omega, inertia=inertia)
    return np.einsum("nij,nj->ni", rotations, omegas), rotations


def with_given_start(wrong):
    """The first rotation is the given one all the same."""

    def begun(t, R, omega, *, inertia):
        omegas, rotations = wrong(t, R, omega, inertia=inertia)
        rotations[0] = R
        return omegas, rotations

    return begun


def start_on_the_other_side(t, R, omega, *, inertia):
    omegas, rotations = from_identity(t, R, omega, inertia=inertia)
    return omegas, rotations @ R


def in_space_from_identity(t, R, omega, *, inertia):
    """A turn from the identity by omega as if in space components, put after the given R."""
    omegas, turns = motion(t, np.eye(3), omega, inertia=inertia, attitude=lambda R, w: hat(w) @ R)
    return omegas, R @ turns


def to_body(t, R, omega, *, inertia):
    omegas, rotations = motion(t, R, omega, inertia=inertia)
    return omegas, rotations.transpose(0, 2, 1)


def at_rounded_times(t, R, omega, *, inertia):
    return motion(np.round(t, 3), R, omega, inertia=inertia)


def given_at_zero(t, R, omega, *, inertia):
    """The given state is that at the time 0, before the start or after it."""
    omegas, rotations = motion(np.array([0.0, t[0]]), R, omega, inertia=inertia)
    return motion(t, rotations[-1], omegas[-1], inertia=inertia)


def given_at_zero_before(t, R, omega, *, inertia):
    """The same, but of a start before t = 0 at that start."""
    return (given_at_zero if t[0] > 0 else motion)(t, R, omega, inertia=inertia)


OMEGA_SUSPECTS = [
    suspect(
        "every sign in Euler's equations changed", within=1e-4, simulate=wrong_motion(euler=signs_changed(-1, -1, -1))
    ),
    suspect(THIRD_IS_ZERO, within=1e-4, simulate=wrong_motion(euler=signs_changed(1, 1, 0))),
    *mistimed(motion, given_at_zero),
    suspect("the times rounded to a millisecond", within=1e-5, simulate=at_rounded_times),
    *(
        suspect("the given state taken for that at t = 0, not at t[0]", within=1e-4, simulate=variant)
        for variant in (given_at_zero_before, with_given_start(given_at_zero_before))
    ),
    suspect("omega in space components", within=1e-4, simulate=in_space_components),
    suspect("solve_ivp at its own tolerances, rtol 1e-3 and atol 1e-6", simulate=wrong_motion(solver={})),
]
MOTION_SUSPECTS = [
    *OMEGA_SUSPECTS,
    suspect(
        "omega-hat R for R omega-hat: omega is in body components",
        within=1e-4,
        simulate=wrong_motion(attitude=lambda R, w: hat(w) @ R),
    ),
    suspect(
        "omega-hat R for R omega-hat, or omega q for q omega: omega is in body components",
        within=1e-4,
        simulate=in_space_from_identity,
    ),
    suspect("the sign of omega-hat changed", within=1e-4, simulate=wrong_motion(attitude=lambda R, w: -R @ hat(w))),
    suspect("rotations that start with the identity, not with the given R", within=1e-4, simulate=from_identity),
    suspect(
        "rotations that go on from the identity, not from the given R",
        within=1e-4,
        simulate=with_given_start(from_identity),
    ),
    suspect("the given R on the wrong side of the turn since then", within=1e-4, simulate=start_on_the_other_side),
    suspect("the transposes, from space to body", within=1e-4, simulate=to_body),
]
NEARLY = "it is nearly right: are the steps short enough, the tolerances tight enough?"


def nearly(error):
    """Whether what is wrong is the accuracy of the integration; np.interp between its steps is off by 2e-2."""
    return error < 3e-2


def judge_motions(found, right, calls, sizes, start, *, hint, **says):
    """The worst motion first, for it decides on partial credit."""
    for values, call, size in zip(found, calls, sizes, strict=True):
        expect(
            values[0],
            call.args[start],
            within=1e-12,
            scale=size,
            of="the first row",
            at=call,
            kind=call.kind,
            hint=partial(wrong_start, values[0]),
        )
    errors = [np.max(np.abs(a - b)) / size for a, b, size in zip(found, right, sizes, strict=True)]
    for worst in np.argsort(errors)[::-1]:
        expect(
            found[worst],
            right[worst],
            within=TRAJECTORY,
            scale=sizes[worst],
            t=calls[worst].args[0],
            at=calls[worst],
            partial={1e-3: 0.5, 1e-2: 0.25},
            kind=calls[worst].kind,
            hint=NEARLY if nearly(errors[worst]) else hint,
            **says,
        )


@check(points=0.75, part="a", suspects=OMEGA_SUSPECTS)
def omega_follows_elliptic_functions(student, draw):
    """simulate: omega against Jacobi's elliptic functions, on both sides of the separatrix and near it."""
    calls, right = tumbles(draw)
    found = [omegas for omegas, _ in student.simulate.many(calls)]
    judge_motions(
        found,
        right,
        calls,
        [np.linalg.norm(call.args[2]) for call in calls],
        2,
        of="omega",
        unit="of its start",
        hint="does euler_equations pass? are the times those asked for?",
    )


@check(points=0.75, part="a", suspects=MOTION_SUSPECTS)
def attitude_follows_the_motion(student, draw):
    """simulate: the rotations along a general motion, from any attitude at the start."""
    calls, right = attitudes(draw)
    found = [rotations for _, rotations in student.simulate.many(calls)]
    judge_motions(found, right, calls, [1.0, 1.0], 1, of="R", hint=partial(look_at_attitude, np.concatenate(found)))


LEFT_HANDED = "the three axes are left-handed: the determinant is -1"


def wrong_start(first):
    """What is wrong with a first row, omega or R."""
    return LEFT_HANDED if first.ndim == 2 and np.linalg.det(first) < 0 else "it is the state given, at t[0]"


def look_at_attitude(rotations):
    if np.linalg.det(rotations).min() < 0:
        return LEFT_HANDED
    defect = np.abs(rotations.transpose(0, 2, 1) @ rotations - np.eye(3)).max()
    if defect > 1e-4:  # the steps are too long, or each one is R + dt R'
        return "R is not kept orthogonal: R^T R is no longer I"
    return "does attitude_rate pass? which components has omega?"


@check(points=0.5, part="a", after=(omega_follows_elliptic_functions, attitude_follows_the_motion))
def invariants_stay_over_many_turns(student, draw):
    """simulate: R^T R = I, the vector H in space and the energy over many turns, fast ones."""
    omega, body, R = a_fast_omega(draw), a_body(draw), an_attitude(draw)
    t = times(draw, omega, 45, count=12)
    kind = "many fast turns"
    omegas, rotations = student.on(kind).simulate(t, R, omega, inertia=body)
    # the half of what it is, which is a quarter of |omega| or more; solve_ivp at 1e-6 is off by a millionth of it
    swing = np.ptp(elliptic(t, omega, body)[LAST_ROWS], axis=0).max()
    expect_that(
        np.ptp(omegas[LAST_ROWS], axis=0).max() > swing / 2,
        "the body does not tumble",
        kind=kind,
        at=(R, omega, body),
        hint="do all rows have the motion at their times?",
    )
    squares, ones = rotations.transpose(0, 2, 1) @ rotations, np.broadcast_to(np.eye(3), rotations.shape)
    expect(
        squares,
        ones,
        within=INVARIANT,
        of="R^T R",
        t=t,
        at=(R, omega, body),
        kind=kind,
        hint=NEARLY if nearly(np.abs(squares - ones).max()) else "is it still a rotation?",
    )
    H = np.einsum("nij,nj->ni", rotations, body * omegas)
    expect(
        H,
        np.broadcast_to(H[0], H.shape),
        within=INVARIANT,
        scale=np.linalg.norm(H[0]),
        of="H in space",
        unit="of itself",
        t=t,
        at=(R, omega, body),
        kind=kind,
        hint=FAST,
    )
    energies = np.array([energy(w, inertia=body) for w in omegas])
    expect(
        energies,
        np.full(len(t), energies[0]),
        within=INVARIANT,
        scale=energies[0],
        of="the energy",
        unit="of its start",
        t=t,
        at=(R, omega, body),
        kind=kind,
        partial={1e-4: 0.5, 1e-2: 0.25},
        hint=FAST,
    )


LAST_ROWS = slice(6, None)  # of 12
FAST = "the steps must be short for a fast turn"


@once
def special_motions(draw):
    """Calls with equal inertias or nothing to turn, what is right, and the kind."""
    cases = {
        "a body with A = B": (a_wheel(draw), an_omega(draw)),
        "a flat disk": (np.array([1.0, 1.0, 2.0]) * 10 ** draw.uniform(-2, 2), an_omega(draw)),
        "three equal inertias": (np.full(3, 10 ** draw.uniform(-2, 2)), an_omega(draw)),
        "a wheel at rest": (a_wheel(draw), np.zeros(3)),
    }
    for kind, (body, omega) in cases.items():
        t, R = times(draw, omega if omega.any() else np.ones(3), 10), an_attitude(draw)
        cases[kind] = given(t, R, omega, inertia=body), wheel(t, R, omega, body)
    omega, body = an_omega(draw), a_wheel(draw)
    t, R = times(draw, omega, 5, count=2), np.eye(3)
    cases["two times, and axes along those of space at the start"] = (
        given(t, R, omega, inertia=body),
        wheel(t, R, omega, body),
    )
    for start, about in HALF_TURNS:
        omega, body = an_omega(draw), a_wheel(draw)
        t = times(draw, omega, 4, count=4)
        cases[f"a start half a turn {about} from the axes of space"] = (
            given(t, start, omega, inertia=body),
            wheel(t, start, omega, body),
        )
    for axis in (0, 1, 2):
        body, omega = a_body(draw), draw.choice([-1, 1]) * draw.uniform(1, 4) * np.eye(3)[axis] + 0.0
        t, R = times(draw, omega, 4), an_attitude(draw)
        cases[f"spin about the principal axis {axis}"] = (given(t, R, omega, inertia=body), spinning(t, R, omega))
    omega, body, R = a_fast_omega(draw), a_wheel(draw), an_attitude(draw)
    t = times(draw, omega, 40, count=2)
    cases[FAST_AND_FAR] = given(t, R, omega, inertia=body), wheel(t, R, omega, body)
    for kind, (t, R, omega, body) in in_turn(draw).items():
        cases[kind] = given(t, R, omega, inertia=body), wheel(t, R, omega, body)
    return cases


def in_turn(draw):
    """A motion, then others of which one thing alone is another: what is kept from one call is wrong in the next."""
    omega, other_omega = an_omega(draw), an_omega(draw)
    first = times(draw, omega, 5, count=4), an_attitude(draw), omega, a_wheel(draw)
    others = times(draw, omega, 5, count=4), an_attitude(draw), other_omega, a_wheel(draw)
    kinds = "other times", "another R", "another omega", "another body with A = B"
    changed = {
        f"the motion of a call before, but for {kind}": (*first[:k], others[k], *first[k + 1 :])
        for k, kind in enumerate(kinds)
    }
    return {"a motion that is asked for again": first, **changed}


FAST_AND_FAR = "a fast body with A = B, and two times many turns apart"


# Their trace is -1: a quaternion that is made by a division by its scalar part has none there.
HALF_TURNS = (
    (np.diag([1.0, -1.0, -1.0]), "about x"),
    (np.diag([-1.0, 1.0, -1.0]), "about y"),
    (2 * np.outer([1, 2, 2], [1, 2, 2]) / 9 - np.eye(3), "about (1, 2, 2)"),
)


def spinning(t, R, omega):
    """omegas and rotations of a body that goes on turning about one of its principal axes."""
    return np.tile(omega, (len(t), 1)), np.array([R @ turned(omega * tau) for tau in t - t[0]])


def wrong_motion_of(found, right, size, kind):
    """What is wrong with a special motion, if it can be told."""
    if found.ndim == 3 and np.abs(found - right.transpose(0, 2, 1)).max() <= TRAJECTORY:
        return "these are the transposes, from space to body"
    if not np.ptp(found, axis=0).any():
        return "it is the same at all times"
    if kind == FAST_AND_FAR:
        return "the steps must be short for a fast turn, and must not depend on the sampling"
    otherwise = "is something kept from one call to the next?" if "a call before" in kind else ""
    return NEARLY if nearly(np.abs(found - right).max() / size) else otherwise


@check(points=0.5, part="a", after=(omega_follows_elliptic_functions, attitude_follows_the_motion))
def special_bodies_move_too(student, draw):
    """simulate: equal inertias, a body at rest, spin about a principal axis, two times alone, starts at half turns."""
    cases = special_motions(draw)
    found = student.simulate.many([call.on(kind) for kind, (call, _) in cases.items()])
    for (omegas, rotations), (kind, (call, right)) in zip(found, cases.items(), strict=True):
        size, says = np.linalg.norm(call.args[2]) or 1.0, {"t": call.args[0], "kind": kind, "at": call}
        expect(
            omegas,
            right[0],
            within=TRAJECTORY,
            scale=size,
            of="omega",
            unit="of its start",
            **says,
            hint=partial(wrong_motion_of, omegas, right[0], size, kind),
        )
        expect(
            rotations,
            right[1],
            within=TRAJECTORY,
            of="R",
            **says,
            hint=partial(wrong_motion_of, rotations, right[1], 1.0, kind),
        )


# (a) A = B


def precessing(rate, since_start=True):
    """omega whose part across the axis turns at rate(inertia, omega)."""

    def solution(t, omega, *, inertia):
        tau = t - t[0] if since_start else t
        across = (omega[0] + 1j * omega[1]) * np.exp(1j * rate(inertia, omega) * tau)
        return np.column_stack([across.real, across.imag, np.full(len(t), omega[2])])

    return solution


def body_rate(inertia, omega):
    """Minus the slip of `wheel`."""
    return (inertia[2] / inertia[0] - 1) * omega[2]


symmetric = precessing(body_rate)


def space_rate(inertia, omega):
    """How fast the symmetry axis e, which moves at omega x e, goes round H."""
    H, e = inertia * omega, np.array([0.0, 0.0, 1.0])
    return np.linalg.norm(H) * np.linalg.norm(np.cross(omega, e)) / np.linalg.norm(np.cross(H, e))


@check(
    points=0.75,
    part="a",
    suspects=[
        suspect("the precession reversed", symmetric_solution=precessing(lambda inertia, w: -body_rate(inertia, w))),
        suspect(
            "the given omega taken at t = 0, not at t[0]", symmetric_solution=precessing(body_rate, since_start=False)
        ),
        suspect("the rate omega_3 of a flat disk, C = 2 A", symmetric_solution=precessing(lambda inertia, w: w[2])),
        suspect(
            "the rate (C - A)/C omega_3: A divides",
            symmetric_solution=precessing(lambda inertia, w: (1 - inertia[0] / inertia[2]) * w[2]),
        ),
        suspect(
            "the rate C/A omega_3, as seen from space",
            symmetric_solution=precessing(lambda inertia, w: inertia[2] / inertia[0] * w[2]),
        ),
        suspect("the rate |H|/A of the wobble in space", symmetric_solution=precessing(space_rate)),
    ],
)
def symmetric_bodies_precess(student, draw):
    """symmetric_solution: omega in body components at all times, from omega at t[0]."""
    bodies = [(a_wheel(draw), "a random body with A = B") for _ in range(6)]
    bodies.append((np.full(3, draw.uniform(0.1, 10)), "three equal inertias"))
    calls = []
    for body, kind in bodies:
        omega = an_omega(draw)
        calls.append(given(times(draw, omega, 40), omega, inertia=body).on(kind))
    judge_precession(student, calls)
    plain = [
        given(times(draw, np.ones(3), 10, 2), omega, inertia=a_wheel(draw)).on(f"two times, {omega_kind(omega)}")
        for omega in plain_omegas(draw)
    ]
    judge_precession(student, plain)


def judge_precession(student, calls):
    for found, call in zip(student.symmetric_solution.many(calls), calls, strict=True):
        t, omega = call.args
        expect(
            found,
            symmetric(t, omega, **call.kwargs),
            within=POINTWISE,
            scale=np.linalg.norm(omega) or 1.0,
            of="omega",
            unit="of its start",
            t=t,
            kind=call.kind,
            at=call,
            hint="compare with euler_equations at the first time",
        )


@check(
    points=0.5,
    part="a",
    suspects=[
        suspect(
            "the rate (C - A)/A omega_3 at which omega goes round in the body",
            wobble_rate=lambda w, *, inertia: abs(body_rate(inertia, w)),
        ),
        suspect(
            "C/A omega_3, for spin very near the axis",
            wobble_rate=lambda w, *, inertia: inertia[2] / inertia[0] * abs(w[2]),
        ),
        suspect(
            "the sign of omega_3 left in the rate",
            wobble_rate=lambda w, *, inertia: math.copysign(space_rate(inertia, w), w[2]),
        ),
        suspect("|H|/C", wobble_rate=lambda w, *, inertia: np.linalg.norm(inertia * w) / inertia[2]),
        suspect("|omega|", wobble_rate=lambda w, *, inertia: np.linalg.norm(w)),
    ],
)
def wobble_goes_round_the_angular_momentum(student, draw):
    """wobble_rate: the rate at which the symmetry axis goes round H, at any angle between them."""
    omegas = [an_omega(draw) for _ in range(8)] + [an_omega(draw) * [0.01, 0.01, 1] for _ in range(4)]
    judge(
        student.wobble_rate,
        [given(omega, inertia=a_wheel(draw)) for omega in omegas],
        lambda omega, inertia: space_rate(inertia, omega),
        of="the rate",
        kind="a random body with A = B",
        hint="split omega into a part along H and one along the symmetry axis",
    )
    # about the symmetry axis alone nothing wobbles
    across = [
        given(omega, inertia=a_wheel(draw)).on(omega_kind(omega) if omega[2] else "omega across the symmetry axis")
        for omega in plain_omegas(draw)
        if omega[:2].any()
    ]
    judge(student.wobble_rate, across, lambda omega, inertia: space_rate(inertia, omega), of="the rate")


# (b) Stability and tumbling


def linear_rates(axis, spin, inertia):
    """(3, 3): the rates of small deviations from spin about an axis."""
    inertia, omega = np.asarray(inertia), spin * np.eye(3)[axis]
    columns = [(np.cross(inertia * d, omega) + np.cross(inertia * omega, d)) / inertia for d in np.eye(3)]
    return np.column_stack(columns)


def growth(axis, spin, *, inertia):
    """Deviations of the next axis grow at a rate whose square is this."""
    M, other = linear_rates(axis, spin, inertia), (axis + 1) % 3
    return (M @ M)[other, other]


def growth_of(wrong):
    """A variant that gives wrong(spin, right)."""
    return lambda axis, spin, *, inertia: wrong(spin, growth(axis, spin, inertia=inertia))


@check(
    points=0.75,
    part="b",
    suspects=[
        suspect("the sign changed", growth_rate_squared=growth_of(lambda spin, right: -right)),
        suspect(
            "the rate, not its square",
            growth_rate_squared=growth_of(lambda spin, right: np.sign(right) * math.sqrt(abs(right))),
        ),
        *(
            suspect(
                "the spin not squared", growth_rate_squared=growth_of(lambda spin, right, size=size: right / size(spin))
            )
            for size in (abs, float)
        ),
        suspect(
            "axes counted from 1",
            growth_rate_squared=lambda axis, spin, *, inertia: growth((axis - 1) % 3, spin, inertia=inertia),
        ),
        suspect(
            "the inertias put in order first: the axis is that of the inertias as they are given",
            growth_rate_squared=lambda axis, spin, *, inertia: growth(axis, spin, inertia=np.sort(inertia)),
        ),
        suspect(
            "the sign of the spin left in its square",
            growth_rate_squared=growth_of(lambda spin, right: np.sign(spin) * right),
        ),
    ],
)
def small_deviations_grow_at_this_rate(student, draw):
    """growth_rate_squared: positive where spin about the axis is unstable, minus the frequency's square where not."""
    bodies = [*(a_body(draw) for _ in range(6)), a_wheel(draw)]
    for axis in (0, 1, 2):
        spins = draw.uniform(1.5, 6, 7) * draw.choice([-1, 1], 7)
        calls = [
            given(axis, spin, inertia=body).on(f"a {'positive' if spin > 0 else 'negative'} spin about axis {axis}")
            for spin, body in zip(spins, bodies, strict=True)
        ]
        judge(
            student.growth_rate_squared,
            calls,
            growth,
            size=lambda axis, spin, inertia: spin**2,
            unit="of spin^2",
            of="the square of the rate",
            hint="keep what is linear in the two small components of omega",
        )
        spin, A = draw.uniform(1.5, 6), draw.uniform(0.5, 2)
        plain = [
            given(axis, spin, inertia=np.full(3, A)).on("three equal inertias"),
            given(axis, 0.0, inertia=a_body(draw)).on("no spin"),
        ]
        judge(
            student.growth_rate_squared,
            plain,
            growth,
            size=lambda axis, spin, inertia: spin**2,
            unit="of spin^2",
            of="the square of the rate",
        )


def squares(omega, inertia):
    """Squares of the two numbers whose arithmetic-geometric mean gives the period, smaller first; ABC beside them."""
    A, B, C = inertia
    p, q, r = np.square(omega)
    beside = B * (B - A) * (C - B) * q
    round_first, round_last = A * (B - A) * p, C * (C - B) * r
    return (C - A) * abs(round_last - round_first), beside + (C - A) * max(round_first, round_last), A * B * C


def tumbling(omega, *, inertia):
    """The period, 4 K(k) over the rate, by Carlson's integral."""
    smaller, larger, product = squares(omega, inertia)
    return 4 * math.sqrt(product) * elliprf(0.0, smaller, larger)


def modulus_for_parameter(omega, *, inertia):
    smaller, larger, product = squares(omega, inertia)
    return 4 * math.sqrt(product / larger) * ellipk(math.sqrt(1 - smaller / larger))


def one_side_only(folded, order):
    """The formula for omega round the last axis, or the first in reverse order, where folded(k^2 > 1) is below one."""

    def wrong(omega, *, inertia):
        (A, B, C), w = inertia[order], omega[order]
        double, square = 2 * energy(w, inertia=inertia[order]), np.sum((inertia * omega) ** 2)
        m = (B - A) * (double * C - square) / ((C - B) * (square - double * A))
        return 4 * math.sqrt(A * B * C / ((C - B) * (square - double * A))) * ellipk(folded(m))

    return wrong


def other_side(order):
    """The suspects that know this side of the separatrix only."""
    folds = (lambda m: min(m, 1 / m)), (lambda m: max(1 - abs(1 - m), 0.0))
    return [
        suspect("the formula for the other side of the separatrix", tumble_period=one_side_only(folded, order))
        for folded in folds
    ]


LAST_AXIS, FIRST_AXIS = slice(None), slice(None, None, -1)


TUMBLE_SUSPECTS = [
    suspect("half of the period", tumble_period=lambda w, *, inertia: tumbling(w, inertia=inertia) / 2),
    suspect("twice the period", tumble_period=lambda w, *, inertia: tumbling(w, inertia=inertia) * 2),
    suspect("k where ellipk wants k^2", tumble_period=modulus_for_parameter),
]


def judge_periods(student, draw, sign, kind):
    cases = [on_side(draw, sign) for _ in range(6)]
    calls = [given(omega[np.argsort(body)], inertia=np.sort(body)) for body, omega in cases]
    judge(
        student.tumble_period,
        calls,
        tumbling,
        within=PERIOD,
        of="the period",
        kind=kind,
        hint="after what time is omega back, sign and all?",
    )
    body = sorted_body(draw)
    plain = [given(omega, inertia=body) for omega in in_planes(body, sign)]
    judge(student.tumble_period, plain, tumbling, within=PERIOD, of="the period", kind=f"{kind}, in a principal plane")


def in_planes(body, sign):
    """omegas in principal planes, round the last axis for sign 1, round the first for -1."""
    A, B, C = body
    first, middle, last = np.diag([1 / math.sqrt(A * (B - A)), 1 / B, 1 / math.sqrt(C * (C - B))])
    about, other = (last, first) if sign > 0 else (first, last)
    return [about + other / 2, about - other / 2, -about + middle, -about - middle]


@check(points=0.375, part="b", suspects=[*TUMBLE_SUSPECTS, *other_side(FIRST_AXIS)])
def period_round_the_last_axis(student, draw):
    """tumble_period where omega goes round the axis of the largest inertia."""
    judge_periods(student, draw, 1, "omega round the axis of the largest inertia")


@check(points=0.375, part="b", suspects=[*TUMBLE_SUSPECTS, *other_side(LAST_AXIS)])
def period_round_the_first_axis(student, draw):
    """tumble_period where omega goes round the axis of the smallest inertia."""
    judge_periods(student, draw, -1, "omega round the axis of the smallest inertia")


@check(points=0.25, part="b", after=(period_round_the_last_axis, period_round_the_first_axis))
def period_of_pure_spin_is_that_of_small_oscillations(student, draw):
    """tumble_period for pure spin about axis 0 or 2: the period of small oscillations about it."""
    for axis, sign in ((0, 1), (0, -1), (2, 1), (2, -1)):
        spin = sign * draw.uniform(1, 4)
        kind = f"pure spin about axis {axis}{', at a negative rate' if sign < 0 else ''}"
        judge(
            student.tumble_period,
            [given(spin * np.eye(3)[axis] + 0.0, inertia=sorted_body(draw))],
            lambda omega, inertia, axis=axis: 2 * math.pi / math.sqrt(-growth(axis, omega[axis], inertia=inertia)),
            within=PERIOD,
            of="the period",
            kind=kind,
            hint="k = 0 there",
        )


def beside_separatrix(draw, distance):
    """A call with C (C - B) r^2 = (1 + distance) A (B - A) p^2, beyond the separatrix for a positive distance.

    At 1e-6, k by energy and H^2 gives the period to 4e-10, events of solve_ivp at 1e-9 give it to 4e-7 (RK45).
    """
    body, (p, q) = sorted_body(draw), draw.uniform(0.4, 1, 2)
    A, B, C = body
    r = p * math.sqrt((1 + distance) * A * (B - A) / (C * (C - B)))
    return given(draw.uniform(1, 4) * draw.choice([-1, 1], 3) * [p, q, r], inertia=body)


@check(points=0.25, part="b", after=(period_round_the_last_axis, period_round_the_first_axis))
def period_grows_to_infinity_at_the_separatrix(student, draw):
    """tumble_period near the separatrix, on both sides of it, and math.inf on it."""
    spins = draw.uniform(1, 4, 4) * draw.choice([-1, 1], 4)
    near = [(0, 1, 3e-5), (0, 1, -1e-3), (3e-5, 1, 0), (-1e-3, 1, 0)]
    calls = [given(spin * np.array(omega), inertia=sorted_body(draw)) for spin, omega in zip(spins, near, strict=True)]
    judge(
        student.tumble_period,
        calls,
        tumbling,
        within=NEAR_PERIOD,
        of="the period",
        kind="omega almost about the middle axis",
        hint="how near 1 is a k that is not 1?",
    )
    calls = [beside_separatrix(draw, sign * distance) for distance in (1e-2, 1e-4, 1e-6) for sign in (1, -1)]
    judge(
        student.tumble_period,
        calls,
        tumbling,
        within=NEAR_PERIOD,
        of="the period",
        kind="omega next to the separatrix, not about the middle axis",
        hint="how near 1 is a k that is not 1?",
    )
    # Whole numbers times powers of two: on the separatrix, 3 (4 - 3) 2^2 = 6 (6 - 4) 1^2, without any rounding
    body = np.array([3.0, 4.0, 6.0]) * 2.0 ** draw.integers(-5, 6)
    for omega, kind in (((0, 1, 0), "pure spin about the middle axis"), ((2, 1, -1), "omega on the separatrix")):
        found = student.on(kind).tumble_period(np.array(omega) * 0.25 * draw.integers(1, 9), inertia=body)
        expect_that(found == math.inf, "the period is finite", kind=kind, hint="what is K(k) for k = 1?")


# Drawing


@check(points=0.5, part="b")
def the_box_has_its_twelve_edges(student, draw):
    """wireframe: the edges of the turned box, in any order and direction."""
    sizes = [draw.permutation(10 ** draw.uniform(-1, 1) * np.array([1, 1.7, 2.9])) for _ in range(6)]
    cases = [(an_attitude(draw), size, "a random attitude and size") for size in sizes[:3]]
    cases += [(R, size, f"a box, {kind}") for (R, kind), size in zip(named_attitudes(draw), sizes[3:], strict=True)]
    cases.append((an_attitude(draw), np.full(3, sizes[0][0]), "a cube"))
    judge_boxes(student.wireframe, cases, within=POINTWISE)


@once
def wobble(draw):
    """A call of plot_rim_paths with a disk near its spin axis, and the rotations times the radius, finely."""
    body = np.array([1.0, 1.0, 2.0]) * 10 ** draw.uniform(-2, 2)
    spin, radius = draw.uniform(1, 4), 10 ** draw.uniform(-1, 1)
    omega = spin * np.array([*draw.uniform(0.1, 0.2, 2), 1.0])
    start, end = draw.uniform(-2, 2) + np.array([0, draw.uniform(4, 6)]) / spin
    R = an_attitude(draw)
    fine = radius * wheel(np.linspace(start, end, 801), R, omega, body)[1]
    # every second, fourth, fifth, eighth or tenth of 401 times ends with the last one
    return given(np.linspace(start, end, 401), R, omega, inertia=body, radius=radius), fine


@once
def tumble(draw):
    """As `wobble`, of a body with three different inertias, and omega along none of its axes."""
    body = np.array([1.0, 1.7, 2.2]) * 10 ** draw.uniform(-2, 2)
    spin, radius = draw.uniform(1, 4), 10 ** draw.uniform(-1, 1)
    omega, R = spin * np.array([0.5, -0.7, 0.5]), an_attitude(draw)
    start, end = draw.uniform(-2, 2) + np.array([0, 5.0]) / spin
    fine = radius * motion(np.linspace(start, end, 801), R, omega, inertia=body)[1]
    return given(np.linspace(start, end, 401), R, omega, inertia=body, radius=radius), fine


def strays(line, fine):
    """How far a drawn path is from the right one, both taken as polygons that begin and end alike.

    The right one may be ten times as far from the drawn one, which may have fewer points.
    """
    path = along(line, fine)
    ends = np.linalg.norm(path[[0, -1]] - fine[[0, -1]], axis=1)
    return max(*ends, distances(path, fine).max(), distances(fine, path).max() / 10)


MISTAKEN_PATHS = {
    "they are seen along x": lambda fine, radius: fine[:, 1:, 0],
    "they are seen along y": lambda fine, radius: fine[:, ::2, 0],
    "they are those of the points (0, radius, 0) and (0, -radius, 0)": lambda fine, radius: fine[:, :2, 1],
    "they are those of the transposes of R": lambda fine, radius: fine[:, 0, :2],
    "they start with the identity, not with the given R": lambda fine, radius: (fine[0].T @ fine)[:, :2, 0] / radius,
    "they are those of a radius of 1 m": lambda fine, radius: fine[:, :2, 0] / radius,
}


def farthest(found, path):
    """How far two drawn paths are from this one and the one opposite; either may be drawn first."""
    return min(max(map(strays, found, paths)) for paths in ((path, -path), (-path, path)))


def ends_early(line, fine, near):
    """Whether a line goes along the right path, from its start, but not to its end."""
    path = along(line, fine)
    first, last = np.linalg.norm(path[[0, -1]] - fine[[0, -1]], axis=1)
    return first < near < last and distances(path, fine).max() < near


def wrong_paths(found, picture, fine, radius):
    """Which other paths are drawn, if they are known, else what to draw."""
    path, near = fine[:, :2, 0], 1e-3 * radius
    if found is not picture.lines and farthest(picture.lines, path) < near:
        return "the label of x stands at the axis of y"
    if any(all(map(ends_early, found, paths, (near, near))) for paths in ((path, -path), (-path, path))):
        return "they end before t[-1]"
    known = [says for says, path in MISTAKEN_PATHS.items() if farthest(found, path(fine, radius)) < near]
    return known[0] if known else "x and y, in space, of the body's points (radius, 0, 0) and (-radius, 0, 0)"


def x_to_the_right(picture):
    """The lines, turned over where by its labels a picture is one from below, with y to the right and x up."""
    if not ("y" in words(picture.xlabel) and "x" in words(picture.ylabel)):
        return picture.lines
    return [replace(line, points=line.points[:, ::-1]) for line in picture.lines]


@check(points=0.5, part="a")
def rim_paths_are_drawn(student, draw):
    """plot_rim_paths: the two paths as seen along z, from t[0] to t[-1], with labels and equal scales."""
    # chords of the fine path, over less than a turn, leave the curve by (6/800)^2/8 = 7e-6 of the radius, and those of
    # 26 points, every sixteenth, by (6/25)^2/8 = 7e-3
    for (call, fine), kind in (
        (wobble(draw), "a disk near its spin axis, t[0] not 0"),
        (tumble(draw), "a body with three different inertias, t[0] not 0"),
    ):
        picture = student.on(kind).plot_rim_paths.draw(*call.args, **call.kwargs)
        expect_that(
            len(picture.lines) == 2,
            f"the number of curves on the axes is {len(picture.lines)}, not 2",
            hint="fewer than ten points are no curve",
        )
        radius, found = call.kwargs["radius"], x_to_the_right(picture)
        expect(
            farthest(found, fine[:, :2, 0]),
            0.0,
            within=1e-3,
            scale=radius,
            of="a path",
            unit="of the radius",
            at=call,
            kind=kind,
            hint=partial(wrong_paths, found, picture, fine, radius),
        )
        judge_axes_of_lengths(picture, either=True)
