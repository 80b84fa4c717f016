"""Right functions of hw06 in terms of others, as students write them; diagnosis tries mistakes in these, too."""

import math

import numpy as np

STEP = 1e-3  # of the speed over the wheelbase: difference of two yaw rates
NODES, WEIGHTS = np.polynomial.legendre.leggauss(24)


def friction_force(state, locked, *, friction, **car):
    """Oppose the velocity of the locked axle: that of G, and what the yaw_rate adds beside G."""
    ahead, free = (car["front"], -car["rear"]) if locked == "front" else (-car["rear"], car["front"])
    _, _, _, speed, yaw_rate = state
    sideways_of_G = -free * yaw_rate
    velocity = np.array([speed, sideways_of_G + ahead * yaw_rate])
    return -friction * axle_load(locked, **car) * velocity / (np.hypot(*velocity) or 1.0)


def yaw_growth_rate(speed, locked, **car):
    """Difference the yaw acceleration, odd in the yaw rate, to fourth order."""
    step = STEP * speed / (car["front"] + car["rear"])
    single, twice = (state_derivative(0.0, np.array([0, 0, 0, speed, k * step]), locked, **car)[4] for k in (1, 2))
    return (8 * single - twice) / (6 * step)


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    """Integrate growth over deceleration, by which the logarithm changes; Gauss-Legendre in the speed's logarithm."""
    half = math.log(speed / speed0) / 2
    geometry = {name: car[name] for name in ("mass", "front", "rear", "gravity")}
    slowing = -car["friction"] * axle_load(locked, **geometry) / car["mass"]
    changes = [u * yaw_growth_rate(u, locked, **car) / slowing for u in speed0 * np.exp(half * (1 + NODES))]
    return yaw_rate0 * math.exp(half * np.dot(WEIGHTS, changes))
