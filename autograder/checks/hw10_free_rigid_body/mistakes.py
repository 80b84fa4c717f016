"""Known mistakes of hw10."""

import math

import numpy as np

from tam570_grader.diagnosis.fixed_steps import runge_kutta
from tam570_grader.diagnosis.mistakes import mistake

from . import checks


def rates_of(state, inertia, attitude=None):
    """Rates of omega and of the nine numbers of R, with dR/dt = attitude(R, omega)."""
    omega, R = state[:3], state[3:].reshape(3, 3)
    turning = (attitude or attitude_rate)(R, omega)
    return np.concatenate([euler_equations(omega, inertia=inertia), np.ravel(turning)])


def parts(states):
    return states[:, :3], states[:, 3:].reshape(-1, 3, 3)


def in_space(R, omega):
    """dR/dt as if omega had space components."""
    return -attitude_rate(R.T, omega).T


def by_solve_ivp(t, R, omega, inertia, attitude=None, **settings):
    from scipy.integrate import solve_ivp

    def rates(_, state):
        return rates_of(state, inertia, attitude)

    return parts(solve_ivp(rates, (t[0], t[-1]), np.concatenate([omega, np.ravel(R)]), t_eval=t, **settings).y.T)


def round_the_last_axis(omega, inertia):
    """k^2 and the period over K(k) where omega goes round the last axis; elsewhere k > 1."""
    A, B, C = inertia
    double, square = np.sum(inertia * omega**2), np.sum((inertia * omega) ** 2)
    along = (C - B) * (square - double * A)
    return (B - A) * (double * C - square) / along, 4 * np.sqrt(A * B * C / along)


# Pointwise


@mistake(first_fails=checks.euler_equations_keep_the_angular_momentum)
def euler_equations(reference, omega, *, inertia):
    """You divide all three equations by A; divide by A, B, C."""
    return np.multiply(reference(omega, inertia=inertia), inertia) / inertia[0]


@mistake(first_fails=checks.euler_equations_keep_the_angular_momentum)
def euler_equations(reference, omega, *, inertia):
    """You assume A = B; then omega_3 stays, but here A and B may differ."""
    return np.multiply(reference(omega, inertia=inertia), [1, 1, 0])


@mistake(first_fails=checks.attitude_follows_omega, compared=False)
def attitude_rate(reference, R, omega):
    """You write the rate into the given R; return a new array."""
    R[:] = reference(R, omega)
    return R


@mistake(first_fails=checks.energy_is_half_omega_h)
def energy(reference, omega, *, inertia):
    """You use half of H . H; the energy is half of omega . H."""
    return reference(np.multiply(inertia, omega), inertia=(1.0, 1.0, 1.0))


@mistake(first_fails=checks.angular_momentum_is_in_space_axes)
def angular_momentum(reference, R, omega, *, inertia):
    """You return body components; H is asked for in space components."""
    return np.multiply(inertia, omega)


@mistake(first_fails=checks.angular_momentum_is_in_space_axes)
def angular_momentum(reference, R, omega, *, inertia):
    """You multiply R omega by A, B, C; they belong to the body's axes."""
    return np.multiply(inertia, R @ omega)


@mistake(first_fails=checks.euler_rates_make_omega)
def euler_rates_313(reference, angles, omega):
    """You use omega in space components; it is given in body components."""
    psi, theta, phi = angles
    return reference((-phi, -theta, -psi), omega)[::-1]  # by the angles of the inverse rotation


@mistake(first_fails=checks.euler_rates_make_omega)
def euler_rates_313(reference, angles, omega):
    """You get sin(theta) from a square root; it is negative for a negative theta."""
    psi, theta, phi = angles
    return reference((psi, math.acos(math.cos(theta)), phi), omega)


@mistake(first_fails=checks.euler_rates_are_refused_where_undetermined, compared=False)
def euler_rates_313(reference, angles, omega):
    """You refuse where sin theta is 1e-6; the limit is 1e-12."""
    if abs(math.sin(angles[1])) < 1e-6:
        raise ValueError
    return reference(angles, omega)


# Motions


@mistake(first_fails=checks.omega_follows_elliptic_functions, name="even_times")
def simulate(reference, t, R, omega, *, inertia):
    """You return the states at evenly spaced times; row i is the state at t[i]."""
    return reference(np.linspace(t[0], t[-1], len(t)), R, omega, inertia=inertia)


@mistake(first_fails=checks.omega_follows_elliptic_functions)
def simulate(reference, t, R, omega, *, inertia):
    """You start at t = 0; R and omega are those at t[0]."""
    sense = math.copysign(1.0, t[0])  # with -omega the motion is reversed
    omegas, rotations = reference(np.array([0.0, abs(t[0])]), R, sense * omega, inertia=inertia)
    return reference(t, rotations[-1], sense * omegas[-1], inertia=inertia)


@mistake(first_fails=checks.omega_follows_elliptic_functions)
def simulate(reference, t, R, omega, *, inertia):
    """You return space components of omega; return body components."""
    omegas, rotations = reference(t, R, omega, inertia=inertia)
    return np.einsum("nij,nj->ni", rotations, omegas), rotations


@mistake(first_fails=checks.attitude_follows_the_motion)
def simulate(reference, t, R, omega, *, inertia):
    """You start from R = I; start from the given R."""
    return reference(t, np.eye(3), omega, inertia=inertia)


@mistake(first_fails=checks.attitude_follows_the_motion)
def simulate(reference, t, R, omega, *, inertia):
    """You multiply in the wrong order; R(t) is R(t[0]) times the turn since then, as omega has body components."""
    omegas, turns = reference(t, np.eye(3), omega, inertia=inertia)
    return omegas, turns @ R


@mistake(first_fails=checks.attitude_follows_the_motion)
def simulate(reference, t, R, omega, *, inertia):
    """You turn R with the omega of the start; omega changes, so use that of the same time."""
    _, steadily = reference(t, R, omega, inertia=np.ones(3))
    return reference(t, R, omega, inertia=inertia)[0], steadily


@mistake(first_fails=checks.attitude_follows_the_motion, name="simulated_in_space")
def simulate(reference, t, R, omega, *, inertia):
    """You use dR/dt = omega-hat R; omega has body components, so it is R omega-hat."""
    return by_solve_ivp(t, R, omega, inertia, in_space, method="DOP853", rtol=1e-10, atol=1e-10)


@mistake(first_fails=checks.attitude_follows_the_motion, name="turned_in_space")
def simulate(reference, t, R, omega, *, inertia):
    """You multiply the turn since t[0] by omega from the left; omega has body components: from the right."""
    omegas, turns = by_solve_ivp(t, np.eye(3), omega, inertia, in_space, method="DOP853", rtol=1e-10, atol=1e-10)
    return omegas, R @ turns


@mistake(first_fails=checks.attitude_follows_the_motion)
def simulate(reference, t, R, omega, *, inertia):
    """You return the matrices from space to body; R is from body to space."""
    omegas, rotations = reference(t, R, omega, inertia=inertia)
    return omegas, rotations.transpose(0, 2, 1)


@mistake(first_fails=checks.invariants_stay_over_many_turns, compared=False, numerics=True)
def simulate(reference, t, R, omega, *, inertia):
    """You take 30 Runge-Kutta steps to each time, however far; limit the size of a step."""
    return parts(runge_kutta(lambda y: rates_of(y, inertia), t, [*omega, *np.ravel(R)], 30))


@mistake(first_fails=checks.special_bodies_move_too)
def simulate(reference, t, R, omega, *, inertia):
    """You lose a start that is half a turn; the scalar part of its quaternion is 0, its axis is not."""
    omegas, rotations = reference(t, R if np.trace(R) > 1e-9 - 1 else np.eye(3), omega, inertia=inertia)
    return omegas, np.concatenate([[R], rotations[1:]])


# A = B


@mistake(first_fails=checks.symmetric_bodies_precess, label="a random body with A = B")
def symmetric_solution(reference, t, omega, *, inertia):
    """You get the angle at t[0] from arctan(q/p), the same for (p, q) and (-p, -q); use arctan2(q, p)."""
    p, q, r = omega
    sign = -1.0 if p < 0 else 1.0
    return reference(t, np.array([sign * p, sign * q, r]), inertia=inertia)


@mistake(first_fails=checks.wobble_goes_round_the_angular_momentum)
def wobble_rate(reference, omega, *, inertia):
    """You use C/A omega_3; the rate is that only for omega very near the axis."""
    return inertia[2] / inertia[0] * abs(omega[2])


@mistake(first_fails=checks.wobble_goes_round_the_angular_momentum)
def wobble_rate(reference, omega, *, inertia):
    """You return the rate (C - A)/A omega_3 of omega in the body; return the axis's rate in space."""
    return abs((inertia[2] - inertia[0]) / inertia[0] * omega[2])


# Stability and tumbling


@mistake(first_fails=checks.small_deviations_grow_at_this_rate)
def growth_rate_squared(reference, axis, spin, *, inertia):
    """You return the growth rate; return its square."""
    square = reference(axis, spin, inertia=inertia)
    return math.copysign(math.sqrt(abs(square)), square)


@mistake(first_fails=checks.small_deviations_grow_at_this_rate)
def growth_rate_squared(reference, axis, spin, *, inertia):
    """You sort the inertias; axis counts them as they are given."""
    return reference(axis, spin, inertia=sorted(inertia))


@mistake(first_fails=checks.small_deviations_grow_at_this_rate)
def growth_rate_squared(reference, axis, spin, *, inertia):
    """You divide by the square of the inertia about the axis of spin; divide by the product of the two others."""
    return reference(axis, spin, inertia=inertia) * math.prod(inertia) / inertia[axis] ** 3


@mistake(first_fails=checks.period_round_the_last_axis, label="the largest inertia")
def tumble_period(reference, omega, *, inertia):
    """You return the period of small oscillations about axis 2; the period depends on how far omega swings."""
    A, B, C = inertia
    return 2 * math.pi / abs(omega[2]) * math.sqrt(A * B / ((C - A) * (C - B))) if omega[2] else math.inf


@mistake(first_fails=checks.period_round_the_last_axis)
def tumble_period(reference, omega, *, inertia):
    """You pass the modulus k to ellipk; it takes the parameter k^2."""
    from scipy.special import ellipk

    square, scale = round_the_last_axis(omega, inertia)
    if square > 1:
        square, scale = round_the_last_axis(omega[::-1], inertia[::-1])
    return scale * ellipk(np.sqrt(square))


@mistake(first_fails=checks.period_round_the_last_axis)
def tumble_period(reference, omega, *, inertia):
    """You use the formula for omega round the axis of the smallest inertia; here it goes round that of the largest."""
    from scipy.special import ellipk

    square, scale = round_the_last_axis(omega[::-1], inertia[::-1])
    return scale * ellipk(square if square < 1 else 1 / square)


@mistake(first_fails=checks.period_round_the_first_axis)
def tumble_period(reference, omega, *, inertia):
    """You use the formula for omega round the axis of the largest inertia; here it goes round that of the smallest."""
    from scipy.special import ellipk

    square, scale = round_the_last_axis(omega, inertia)
    return scale * ellipk(square if square < 1 else 1 / square)


@mistake(first_fails=checks.period_of_pure_spin_is_that_of_small_oscillations, compared=False)
def tumble_period(reference, omega, *, inertia):
    """You return math.inf for pure spin about a stable axis; return the period of small oscillations."""
    return reference(omega, inertia=inertia) if np.count_nonzero(omega) > 1 else math.inf


@mistake(first_fails=checks.period_grows_to_infinity_at_the_separatrix, compared=False)
def tumble_period(reference, omega, *, inertia):
    """You return math.inf near the separatrix, too; the period is infinite only on it."""
    H = np.multiply(inertia, omega)
    near = math.isclose(H @ H, inertia[1] * (H @ omega), rel_tol=1e-5)
    return math.inf if near else reference(omega, inertia=inertia)


# Drawing


@mistake(first_fails=checks.the_box_has_its_twelve_edges, compared=False)
def wireframe(reference, R, *, size):
    """You turn the box by the transpose of R; turn it by R."""
    return reference(R.T, size=size)


@mistake(first_fails=checks.rim_paths_are_drawn, compared=False)
def plot_rim_paths(reference, ax, t, R, omega, *, inertia, radius):
    """You draw the paths as seen along space z; there a small tilt shows in second order alone."""
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for axis in (0, 1):
        ax.plot(*radius * rotations[:, :2, axis].T)
    ax.set(xlabel="x (m)", ylabel="y (m)", aspect="equal")


@mistake(first_fails=checks.rim_paths_are_drawn, compared=False)
def plot_rim_paths(reference, ax, t, R, omega, *, inertia, radius):
    """You draw two opposite points of the rim; they run on one circle. Draw (radius, 0, 0) and (0, radius, 0)."""
    _, rotations = simulate(t, R, omega, inertia=inertia)
    for end in (radius, -radius):
        ax.plot(*end * rotations[:, 1:, 0].T)
    ax.set(xlabel="y (m)", ylabel="z (m)", aspect="equal")
