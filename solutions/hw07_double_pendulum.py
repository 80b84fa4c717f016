"""hw07: Double pendulum of two uniform bars.

figure.svg, beside this file, shows the axes, the names and the positive senses.

x is to the right, y up; bar 1 hangs from the ceiling hinge at the origin, bar 2 from the end of bar 1, the elbow.
theta = (th1, th2) are the bars' angles from straight down, both absolute, counter-clockwise positive:
bar i points along (sin th_i, -cos th_i). Two independent equations of motion are

    [M]{alpha} + {f} + {g} = {0}.

They may be angular momentum balances about two points of your choice, Lagrange's equations for th1 and th2, or
combinations. [M], {f} and {g} must come from the same two.

Nothing is off limits in this file.
"""

import math

import numpy as np

from tam570.integrate import solve

__all__ = [
    "angular_acceleration",
    "angular_momentum",
    "energy",
    "free_body_diagram",
    "gravity_terms",
    "mass_matrix",
    "on_the_fly",
    "plot_tip_path",
    "simulate",
    "small_oscillation_frequencies",
    "velocity_terms",
    "wireframe",
]


def free_body_diagram(bar, theta, *, masses, lengths, gravity):
    """The forces on one bar, cut free from the ceiling and from the other bar.

    bar     : 1 or 2
    theta   : (2,) rad
    masses  : (2,) kg, of the bars, positive
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns a list of pairs (point, direction), one for each force: where it acts, (2,) in m, and a vector (2,) of any
    length along which it acts, or None where neither component is known. The order is free.
    Raises ValueError for another bar.
    """
    if bar not in (1, 2):
        raise ValueError(f"bar: {bar!r} is not 1 or 2")
    (ceiling, elbow), (_, tip) = wireframe(theta, lengths=lengths)
    down = (0.0, -1.0)
    if bar == 1:
        return [((ceiling + elbow) / 2, down), (ceiling, None), (elbow, None)]
    return [((elbow + tip) / 2, down), (elbow, None)]


def mass_matrix(theta, *, masses, lengths):
    """[M] of two independent equations of motion; of Lagrange's, half of omega . M omega is the kinetic energy.

    theta   : (2,) rad
    masses  : (2,) kg, of the bars, positive
    lengths : (2,) m
    Returns (2, 2), one row for each equation; of balances of moments kg m^2.
    """
    th1, th2 = theta
    m1, m2 = masses
    l1, l2 = lengths
    coupling = m2 * l1 * l2 / 2 * math.cos(th1 - th2)
    return np.array([[(m1 / 3 + m2) * l1**2, coupling], [coupling, m2 * l2**2 / 3]])


def velocity_terms(theta, omega, *, masses, lengths):
    """{f} of the same two equations: what is left without gravity at alpha = 0, the centripetal terms.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    Returns (2,), N m.
    """
    th1, th2 = theta
    om1, om2 = omega
    l1, l2 = lengths
    lever = masses[1] * l1 * l2 / 2 * math.sin(th1 - th2)
    return np.array([lever * om2**2, -lever * om1**2])


def gravity_terms(theta, *, masses, lengths, gravity):
    """{g} of the same two equations: what gravity adds.

    theta   : (2,) rad
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,), N m.
    """
    th1, th2 = theta
    m1, m2 = masses
    l1, l2 = lengths
    return gravity * np.array([(m1 / 2 + m2) * l1 * math.sin(th1), m2 * l2 / 2 * math.sin(th2)])


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    """{alpha} from the two equations of motion.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg; one may be as good as massless
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,), rad/s^2.
    """
    state = (*map(float, theta), *map(float, omega))
    return np.array(_rates(0.0, state, **_parameters(masses, lengths, gravity))[2:])


def on_the_fly(theta, omega, *, masses, lengths, gravity):
    """{alpha} and the hinge forces from two free bars: momentum balances and hinge constraints, solved together.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (alpha, hinge_forces): alpha (2,) rad/s^2; hinge_forces (2, 2) N, rows: of the ceiling on
    bar 1, of bar 1 on bar 2; columns: x, y.
    """
    along, across = _directions(theta)
    matrix = _balances_and_constraints(along, across, masses)
    right_side = _weights_and_centripetal(along, np.asarray(lengths) * np.square(omega), masses, gravity)
    unknown = np.linalg.solve(matrix, right_side)
    forces = unknown[6:].reshape(2, 2) * [[sum(masses)], [masses[1]]]
    return unknown[4:6] / lengths, forces


def energy(theta, omega, *, masses, lengths, gravity):
    """Kinetic plus potential energy; the potential is 0 at the height of the ceiling.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns J.
    """
    (m1, m2), (l1, l2) = masses, lengths
    kinetic = 0.5 * np.dot(omega, mass_matrix(theta, masses=masses, lengths=lengths) @ omega)
    height_moments = (m1 / 2 + m2) * l1 * math.cos(theta[0]) + m2 * l2 / 2 * math.cos(theta[1])
    return float(kinetic - gravity * height_moments)


def angular_momentum(theta, omega, *, masses, lengths):
    """Angular momentum of both bars about the ceiling hinge, counter-clockwise positive.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    Returns kg m^2/s.
    """
    # M is Lagrange's: turning the whole adds the same angle to both: the momenta conjugate to th1 and th2 add up
    return float(np.sum(mass_matrix(theta, masses=masses, lengths=lengths) @ omega))


def simulate(t, theta, omega, *, masses, lengths, gravity):
    """The motion from the state theta, omega at t[0].

    t       : (n,) s, strictly increasing, n >= 2; its sampling does not change the motion
    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (n, 4): th1, th2, om1, om2 at t; the angles are not wrapped.
    """
    parameters = _parameters(masses, lengths, gravity)
    return solve(_rates, t, (*theta, *omega), parameters=parameters, rtol=1e-13)


def small_oscillation_frequencies(*, masses, lengths, gravity):
    """Circular frequencies of the two modes about hanging straight down.

    masses  : (2,) kg; one may be as good as massless
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,) rad/s, ascending.
    """
    (m1, m2), (l1, l2) = masses, lengths
    stiff1, stiff2, inert1 = (m1 / 2 + m2) / l1, 0.5 / l2, m1 / 3 + m2  # for l1 th1 and l2 th2
    determinant = m1 / 9 + m2 / 12  # inert1 * 1/3 - m2/2 * 1/2
    apart = math.hypot(stiff1 / 3 - inert1 * stiff2, math.sqrt(m2 * stiff1 * stiff2))
    twice_fast = (stiff1 / 3 + inert1 * stiff2 + apart) / determinant
    slow = 2 * stiff1 * stiff2 / (determinant * twice_fast)  # the product of the roots: no cancellation
    return np.sqrt(gravity * np.array([slow, 0.5 * twice_fast]))


def wireframe(theta, *, lengths):
    """The bars as line segments.

    theta   : (2,) rad
    lengths : (2,) m
    Returns (2, 2, 2): ceiling hinge to elbow, elbow to tip; x and y in m.
    """
    elbow, relative_tip = _directions(theta)[0] * np.reshape(lengths, (2, 1))
    return np.array([[np.zeros(2), elbow], [elbow, elbow + relative_tip]])


def plot_tip_path(ax, t, theta, omega, *, masses, lengths, gravity):
    """Draw the path of the tip of bar 2 from t[0] to t[-1], at equal scales.

    ax      : Matplotlib Axes to draw on; one line
    t       : (n,) s, strictly increasing, dense enough for a smooth line
    theta   : (2,) rad, at t[0]
    omega   : (2,) rad/s, at t[0]
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    """
    angles = simulate(t, theta, omega, masses=masses, lengths=lengths, gravity=gravity)[:, :2]
    ax.plot(np.sin(angles) @ lengths, -np.cos(angles) @ lengths, linewidth=0.8, label="tip of bar 2")
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


def _parameters(masses, lengths, gravity):
    m1, m2 = masses
    l1, l2 = lengths
    return {"m1": float(m1), "m2": float(m2), "l1": float(l1), "l2": float(l2), "gravity": float(gravity)}


def _rates(t, state, m1, m2, l1, l2, gravity):
    """The state's derivative in plain floats.

    The unknowns are p = l1 alpha1 and q = l2 alpha2, the second equation is divided by m2: then the determinant is
    a sum of positive terms, and either bar may be massless.
    """
    th1, th2, om1, om2 = state
    c, s = math.cos(th1 - th2), math.sin(th1 - th2)
    inertia = m1 / 3 + m2
    pull1 = -m2 * l2 / 2 * s * om2 * om2 - (m1 / 2 + m2) * gravity * math.sin(th1)
    pull2 = l1 / 2 * s * om1 * om1 - gravity / 2 * math.sin(th2)
    determinant = m1 / 9 + m2 * (1 / 12 + s * s / 4)  # inertia * 1/3 - (m2 c / 2) * (c / 2)
    p = (pull1 / 3 - m2 * c / 2 * pull2) / determinant
    q = (inertia * pull2 - c / 2 * pull1) / determinant
    return om1, om2, p / l1, q / l2


def _directions(theta):
    """(2, 2) unit vectors along the bars, and those across them, in which the angles grow."""
    s, c = np.sin(theta), np.cos(theta)
    return np.column_stack([s, -c]), np.column_stack([c, s])


# Unknowns of the free bars, made alike in size so that a bar may be massless: the accelerations of G1 and G2,
# l1 alpha1, l2 alpha2, the ceiling's force on bar 1 per mass of both bars, that of bar 1 on bar 2 per mass of bar 2.
G1, G2, P, Q, CEILING, ELBOW = slice(0, 2), slice(2, 4), 4, 5, slice(6, 8), slice(8, 10)


def _balances_and_constraints(along, across, masses):
    """(10, 10) matrix of the unknowns; the rows are in their order: two bars' momenta, angular momenta, two hinges."""
    part1, part2 = np.array(masses) / sum(masses)
    unit = np.eye(2)
    matrix = np.zeros((10, 10))
    matrix[G1, G1], matrix[G1, CEILING], matrix[G1, ELBOW] = part1 * unit, -unit, part2 * unit
    matrix[G2, G2], matrix[G2, ELBOW] = unit, -unit
    matrix[P, P], matrix[P, CEILING], matrix[P, ELBOW] = part1 / 6, across[0], part2 * across[0]
    matrix[Q, Q], matrix[Q, ELBOW] = 1 / 6, across[1]
    matrix[CEILING, G1], matrix[CEILING, P] = unit, -across[0] / 2
    matrix[ELBOW, G1], matrix[ELBOW, P] = unit, across[0] / 2
    matrix[ELBOW, G2], matrix[ELBOW, Q] = -unit, across[1] / 2
    return matrix


def _weights_and_centripetal(along, spins, masses, gravity):
    """(10,) right-hand side; spins = l omega^2 of the bars."""
    right_side = np.zeros(10)
    right_side[1], right_side[3] = -gravity * masses[0] / sum(masses), -gravity
    right_side[CEILING] = -spins[0] / 2 * along[0]
    right_side[ELBOW] = (spins[0] * along[0] + spins[1] * along[1]) / 2
    return right_side
