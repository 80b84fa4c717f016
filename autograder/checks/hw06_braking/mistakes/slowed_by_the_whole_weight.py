"""The car slows by friction times gravity, as if the locked axle carried its whole weight.

fails: small_yaw_rate_is_the_linear_solution
"""

_right_rate = small_yaw_rate


def small_yaw_rate(speed, speed0, yaw_rate0, locked, **car):
    rate = _right_rate(speed, speed0, yaw_rate0, locked, **car)
    load = axle_load(locked, **{name: car[name] for name in ("mass", "front", "rear", "gravity")})
    return yaw_rate0 * (rate / yaw_rate0) ** (load / (car["mass"] * car["gravity"])) if yaw_rate0 else 0.0
