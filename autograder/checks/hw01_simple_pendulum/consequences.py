"""Right functions of hw01 in terms of others, as students write them; diagnosis tries mistakes in these, too."""

import numpy as np


def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    """Compute the tension from the velocity."""
    tension = mass * _speed(omega, length) ** 2 / length + mass * gravity * np.cos(theta)
    return -gravity / length * np.sin(theta), tension


def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    """Compute the moment of the momentum."""
    moment = -mass * gravity * length * np.sin(theta)
    return moment / (mass * length**2), mass * length * _speed(omega, length), moment


def energy_balance(theta, omega, *, mass, length, gravity):
    """Use alpha from the other balances, and the usual form of the potential."""
    potential = _potential(theta, mass, length, gravity)
    return -gravity / length * np.sin(theta), _kinetic(omega, mass, length), potential


def power_balance(theta, omega, *, mass, length, gravity):
    """Compute the power from the velocity."""
    power = -mass * gravity * _speed(omega, length) * np.sin(theta)
    return -gravity / length * np.sin(theta), power


def action(theta, step, *, mass, length, gravity):
    """Integrate T - V with values at the middle of each step."""
    omega, middle = np.diff(theta) / step, (theta[:-1] + theta[1:]) / 2
    return step * np.sum(_kinetic(omega, mass, length) - _potential(middle, mass, length, gravity))


def small_angle_solution(t, theta0, omega0, *, length, gravity):
    """Use an amplitude and a phase."""
    rate = np.sqrt(gravity / length)
    phase = rate * t - np.arctan2(omega0 / rate, theta0)
    amplitude = np.hypot(theta0, omega0 / rate)
    return np.column_stack([amplitude * np.cos(phase), -amplitude * rate * np.sin(phase)])


def _speed(omega, length):
    return length * omega


def _potential(theta, mass, length, gravity):
    return mass * gravity * length * (1 - np.cos(theta))


def _kinetic(omega, mass, length):
    return mass * _speed(omega, length) ** 2 / 2
