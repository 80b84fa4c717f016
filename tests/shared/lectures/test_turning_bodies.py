"""Laws of the lectures on rotations, gimbals, cones, bearings, matrices as states, coordinates that do not exist."""

import math

import numpy as np
import pytest

from tam570 import rotations
from tam570.integrate import solve, solve_rotation
from tam570.invariants import growth_exponent, rotation_defect
from tam570.lectures import bearings, cones, drifting_matrix, dyads, gimbals, sphere, wrong_coordinates
from tam570.rotations import exp

DRAW = np.random.default_rng(571)
STEP = 1e-5  # of central differences, with an error of 1e-10, and of 1e-11 by rounding
BODIES = [
    {"axial": C, "transverse": A, "spin": s, "wobble": w}
    for C, A in ((2.0, 1.0), (0.3, 1.4), (1.0, 1.0))
    for s, w in ((2.0, 0.7), (-1.5, 0.4), (0.0, 1.0), (3.0, 0.0), (1.0, -0.5))
]


@pytest.mark.parametrize("sequence", ["313", "312"])
class TestGimbals:
    def test_rings_turn_in_order(self, sequence):
        angles = DRAW.uniform(-3, 3, 3)
        first, both, all_three = gimbals.rings(angles, sequence)
        assert all_three == pytest.approx(rotations.matrix_from_euler(sequence, angles), abs=1e-14)
        assert first == pytest.approx(rotations.matrix_from_axis_angle([0, 0, 1], angles[0]), abs=1e-14)
        assert both[:, 0] == pytest.approx(first[:, 0], abs=1e-14)  # the second turn is about x

    def test_omega_is_the_vector_of_R_dot_R_transposed(self, sequence):
        angles, rates = DRAW.uniform(-3, 3, 3), DRAW.normal(size=3)
        after, before = (gimbals.rings(angles + s * STEP * rates, sequence)[2] for s in (1, -1))
        spin = (after - before) / (2 * STEP) @ gimbals.rings(angles, sequence)[2].T
        assert gimbals.angular_velocity(angles, rates, sequence) == pytest.approx(rotations.unskew(spin), abs=1e-8)

    def test_both_directions_are_inverse(self, sequence):
        for _ in range(20):
            angles, rates = DRAW.uniform(-3, 3, 3), DRAW.normal(size=3)
            omega = gimbals.angular_velocity(angles, rates, sequence)
            # near the lock, the rates are much larger than omega
            assert gimbals.euler_rates(angles, omega, sequence) == pytest.approx(rates, rel=1e-9, abs=1e-9)

    def test_the_lock_is_told_by_its_angle(self, sequence):
        for theta in (0.0, math.pi) if sequence == "313" else (math.pi / 2, -math.pi / 2):
            with pytest.raises(ValueError, match="theta"):
                gimbals.euler_rates([0.3, theta, 0.1], [1.0, 2.0, 3.0], sequence)
        near = 1e-6 if sequence == "313" else math.pi / 2 - 1e-6
        assert np.isfinite(gimbals.euler_rates([0.3, near, 0.1], [1.0, 2.0, 3.0], sequence)).all()


@pytest.mark.parametrize("body", BODIES)
def test_cones_touch_and_roll(body):
    """omega is on both cones, which roll over equal arcs."""
    t = np.linspace(0.0, 3.0, 7)
    omega, axis = cones.omega(t, **body), cones.axis(t, **body)
    size = math.hypot(body["spin"], body["wobble"])
    assert np.linalg.norm(omega, axis=1) == pytest.approx(np.full(7, size))
    assert np.sum(omega * axis, axis=1) / size == pytest.approx(np.full(7, math.cos(cones.body_cone(**body))))
    assert omega[:, 2] / size == pytest.approx(np.full(7, math.cos(cones.space_cone(**body))))
    in_space = cones.precession_rate(**body) * math.sin(cones.space_cone(**body))
    in_body = cones.body_rate(**body) * math.sin(cones.body_cone(**body))
    assert in_space == pytest.approx(in_body, rel=1e-12, abs=1e-12)


@pytest.mark.parametrize("body", BODIES)
def test_cones_are_the_free_motion_of_the_body(body):
    """The axis moves with the body, axis' = omega x axis, and the angular momentum H is constant."""
    t = np.linspace(0.0, 3.0, 7)
    omega, axis = cones.omega(t, **body), cones.axis(t, **body)
    rate = (cones.axis(t + STEP, **body) - cones.axis(t - STEP, **body)) / (2 * STEP)
    assert rate == pytest.approx(np.cross(omega, axis), abs=1e-8)
    along = np.sum(omega * axis, axis=1)[:, None] * axis
    H = body["transverse"] * (omega - along) + body["axial"] * along
    assert pytest.approx(np.tile(H[0], (7, 1)), abs=1e-12) == H
    assert cones.precession_rate(**body) == pytest.approx(np.linalg.norm(H[0]) / body["transverse"])


def test_cones_in_their_limits():
    spinning = {"axial": 2.0, "transverse": 1.0, "spin": 3.0}
    assert cones.body_cone(**spinning, wobble=0.0) == 0.0 == cones.space_cone(**spinning, wobble=0.0)
    assert cones.precession_rate(**spinning, wobble=1e-4) == pytest.approx(2 * 3.0, rel=1e-8)  # a disk: twice its spin
    assert cones.omega(0.5, **spinning, wobble=1.0).shape == (3,)
    assert (cones.omega([0.0, 1.0], **{**spinning, "spin": 0.0}, wobble=0.0) == 0).all()


def test_bearings_give_the_rate_of_angular_momentum():
    """The moment is the rate of H in space, by differences at t = 0, where the body's axes are those of space."""
    for _ in range(5):
        points, (spin, spin_rate) = DRAW.normal(size=(6, 3)), DRAW.normal(size=2)
        body = np.sum(points**2) * np.eye(3) - points.T @ points

        def momentum(t, body=body, spin=spin, spin_rate=spin_rate):
            R = rotations.matrix_from_axis_angle([0, 0, 1], spin * t + spin_rate * t * t / 2)
            return R @ body @ [0, 0, spin + spin_rate * t]

        rate = (momentum(STEP) - momentum(-STEP)) / (2 * STEP)
        assert bearings.moment(body, spin, spin_rate) == pytest.approx(rate, abs=1e-7)


def triad():
    return exp(DRAW.normal(size=3))


def test_the_matrix_moves_as_euler_has_it():
    """Two derivations agree: omega in space with H constant, and omega in the body with Euler's equations."""
    moments = {"inertia": (1.0, 2.3, 2.9)}
    for _ in range(5):
        R, omega = triad(), DRAW.normal(size=3)
        body = wrong_coordinates.rates(0.0, [*R.ravel(), *omega], **moments)
        space = drifting_matrix.rates(0.0, [*R.ravel(), *(R @ omega)], **moments)
        assert space[:9] == pytest.approx(body[:9], abs=1e-13)
        assert space[9:] == pytest.approx(R @ body[9:], abs=1e-13)  # omega x omega = 0


def test_the_matrix_drifts_and_rotations_do_not():
    m, times = drifting_matrix, np.linspace(0.0, 1000.0, 101)
    states = solve(m.rates, times, m.START, parameters=m.EXAMPLE, rtol=1e-6, method="python")
    defects = rotation_defect(states[:, :9].reshape(-1, 3, 3))
    assert growth_exponent(times[1:], defects[1:]) == pytest.approx(1.0, abs=0.15)
    A, B, C = m.EXAMPLE["inertia"]

    def euler(t, w):
        return (B - C) * w[1] * w[2] / A, (C - A) * w[2] * w[0] / B, (A - B) * w[0] * w[1] / C

    _, matrices = solve_rotation(euler, times, m.START[9:], np.eye(3), rtol=1e-6)
    assert rotation_defect(matrices).max() < 1e-14 < 1e-6 < defects[-1]  # only rounding, against drift


def test_the_wrong_coordinates_keep_energy_and_size_and_lose_the_direction():
    m, times = wrong_coordinates, np.linspace(0.0, 5.0, 11)
    states = solve(m.wrong_rates, times, m.START, parameters=m.EXAMPLE)
    H = np.array([m.angular_momentum(state, **m.EXAMPLE) for state in states])
    energies = [m.energy(state, **m.EXAMPLE) for state in states]
    assert energies == pytest.approx([energies[0]] * 11, rel=1e-9)
    assert np.linalg.norm(H, axis=1) == pytest.approx(np.full(11, np.linalg.norm(H[0])), rel=1e-9)
    assert np.linalg.norm(H - H[0], axis=1).max() > 0.1 * np.linalg.norm(H[0])


@pytest.mark.parametrize("mirror", [1.0, -1.0])
def test_three_dyads_take_one_triad_to_the_other(mirror):
    before, after = mirror * triad(), mirror * triad()
    R = dyads.rotation(before, after)
    for old, new in zip(before, after, strict=True):
        assert R @ old == pytest.approx(new, abs=1e-15)
    assert np.abs(R @ R.T - np.eye(3)).max() < 1e-14
    assert np.linalg.det(R) == pytest.approx(1.0)


def test_nine_dyads_rebuild_the_rotation():
    R, base = triad(), triad()
    result = dyads.nine(R, base)
    rebuilt = sum(result[i, j] * dyads.dyad(base[i], base[j]) for i in range(3) for j in range(3))
    assert rebuilt == pytest.approx(R, abs=1e-14)
    assert dyads.nine(R, np.eye(3)) == pytest.approx(R)


@pytest.mark.parametrize("size", [1e-300, 1e-160, 1e-8, 1.0, 3.0, 20.0])
def test_the_triangle_composes_as_matrices_do(size):
    for _ in range(20):
        first, second = size * DRAW.normal(size=(2, 3))
        result = sphere.compose(first, second)
        assert np.linalg.norm(result) <= math.pi + 1e-15
        assert exp(result) == pytest.approx(exp(second) @ exp(first), abs=1e-13)
