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

import numpy as np

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
    raise NotImplementedError


def mass_matrix(theta, *, masses, lengths):
    """[M] of two independent equations of motion; of Lagrange's, half of omega . M omega is the kinetic energy.

    theta   : (2,) rad
    masses  : (2,) kg, of the bars, positive
    lengths : (2,) m
    Returns (2, 2), one row for each equation; of balances of moments kg m^2.
    """
    raise NotImplementedError


def velocity_terms(theta, omega, *, masses, lengths):
    """{f} of the same two equations: what is left without gravity at alpha = 0, the centripetal terms.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    Returns (2,), N m.
    """
    raise NotImplementedError


def gravity_terms(theta, *, masses, lengths, gravity):
    """{g} of the same two equations: what gravity adds.

    theta   : (2,) rad
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,), N m.
    """
    raise NotImplementedError


def angular_acceleration(theta, omega, *, masses, lengths, gravity):
    """{alpha} from the two equations of motion.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg; one may be as good as massless
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,), rad/s^2.
    """
    raise NotImplementedError


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
    raise NotImplementedError


def energy(theta, omega, *, masses, lengths, gravity):
    """Kinetic plus potential energy; the potential is 0 at the height of the ceiling.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns J.
    """
    raise NotImplementedError


def angular_momentum(theta, omega, *, masses, lengths):
    """Angular momentum of both bars about the ceiling hinge, counter-clockwise positive.

    theta   : (2,) rad
    omega   : (2,) rad/s
    masses  : (2,) kg
    lengths : (2,) m
    Returns kg m^2/s.
    """
    raise NotImplementedError


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
    raise NotImplementedError


def small_oscillation_frequencies(*, masses, lengths, gravity):
    """Circular frequencies of the two modes about hanging straight down.

    masses  : (2,) kg; one may be as good as massless
    lengths : (2,) m
    gravity : m/s^2, may be 0
    Returns (2,) rad/s, ascending.
    """
    raise NotImplementedError


def wireframe(theta, *, lengths):
    """The bars as line segments.

    theta   : (2,) rad
    lengths : (2,) m
    Returns (2, 2, 2): ceiling hinge to elbow, elbow to tip; x and y in m.
    """
    raise NotImplementedError


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
    raise NotImplementedError
