"""Visible tests of hw11: run them with `tam570 check hw11` (or plain pytest) as often as you like."""

import math

import hw11_disk_steady as hw
import numpy as np
import pytest

# mass 2 kg, radius .5 m, so that m a^2 is .5 kg m^2
DISK = {"mass": 2.0, "radius": 0.5, "inertia": np.array([0.125, 0.25]), "gravity": 10.0}  # thin and uniform
HOOP = {**DISK, "inertia": np.array([0.25, 0.5])}
LEAN = 0.4  # rad


def residual(lean, precession, spin, force, disk):
    """hw.moment_residual of a disk under this force."""
    body = {key: disk[key] for key in ("mass", "radius", "inertia")}
    return float(hw.moment_residual(lean, precession, spin, *force, **body))


def force_on(lean, precession, spin, disk):
    body = {key: disk[key] for key in ("mass", "radius", "gravity")}
    return [float(component) for component in hw.contact_force(lean, precession, spin, **body)]


def test_the_thin_disk_on_a_wide_track():
    R = 3.0  # m
    expected = math.sqrt(4 * 10.0 * math.tan(LEAN) / (6 * R - 5 * 0.5 * math.sin(LEAN)))
    assert float(hw.rolling_precession(LEAN, R, **DISK)) == pytest.approx(expected)


@pytest.mark.parametrize("disk", [DISK, HOOP])
@pytest.mark.parametrize("lean", [LEAN, -0.7])
def test_rolling_balances_the_moments(disk, lean):
    spin = float(hw.rolling_spin(lean, -1.5, **disk))
    force = force_on(lean, -1.5, spin, disk)
    assert residual(lean, -1.5, spin, force, disk) == pytest.approx(0.0, abs=1e-9)


@pytest.mark.parametrize("disk", [DISK, HOOP])
def test_sliding_balances_the_moments(disk):
    spin = float(hw.sliding_spin(LEAN, 2.5, **disk))
    assert residual(LEAN, 2.5, spin, (0.0, 20.0), disk) == pytest.approx(0.0, abs=1e-9)


def test_a_leaning_disk_at_rest_falls():
    assert residual(LEAN, 0.0, 0.0, (0.0, 20.0), DISK) == pytest.approx(20.0 * 0.5 * math.sin(LEAN))


def test_track_radius_and_precession_agree():
    R = float(hw.rolling_track_radius(LEAN, 1.5, **DISK))
    assert float(hw.rolling_precession(LEAN, R, **DISK)) == pytest.approx(1.5)


def test_rolling_means_that_the_contact_is_at_rest():
    spin, R = float(hw.rolling_spin(LEAN, 1.5, **HOOP)), float(hw.rolling_track_radius(LEAN, 1.5, **HOOP))
    assert 0.5 * spin == pytest.approx(1.5 * (R - 0.5 * math.sin(LEAN)))


def test_the_centre_rests_while_the_disk_slides():
    assert float(hw.sliding_track_radius(LEAN, radius=0.5)) == pytest.approx(0.5 * math.sin(LEAN))


def test_the_common_motion_has_no_spin():
    omega = float(hw.common_precession(LEAN, **HOOP))
    assert omega > 0
    assert float(hw.rolling_spin(LEAN, omega, **HOOP)) == pytest.approx(0.0, abs=1e-9)
    assert float(hw.sliding_spin(LEAN, omega, **HOOP)) == pytest.approx(0.0, abs=1e-9)


def test_the_energy_is_lost_as_the_coin_settles():
    high, low = float(hw.settling_energy(-0.5, **DISK)), float(hw.settling_energy(-1.5, **DISK))
    assert high > low > 2.0 * 10.0 * 0.5 * math.cos(1.5)  # the potential energy alone


@pytest.mark.parametrize(("lean", "track_radius"), [(-LEAN, 3.0), (0.0, 0.0)])
def test_what_does_not_exist_is_refused(lean, track_radius):
    with pytest.raises(ValueError):
        hw.rolling_precession(lean, track_radius, **DISK)


def test_no_gravity_no_precession():
    assert float(hw.rolling_precession(LEAN, 3.0, **{**DISK, "gravity": 0.0})) == 0.0
