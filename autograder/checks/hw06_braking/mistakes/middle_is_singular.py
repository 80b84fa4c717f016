"""For front = rear you return no yaw acceleration; the car still turns.

fails: equations_without_friction_and_at_rest, growth_rate_is_the_slope
"""

_right_derivative, _right_growth = state_derivative, yaw_growth_rate


def state_derivative(t, state, locked, *, front, rear, **car):
    rates = _right_derivative(t, state, locked, front=front, rear=rear, **car)
    return np.append(rates[:4], rates[4] if front != rear else 0.0)


def yaw_growth_rate(speed, locked, *, front, rear, **car):
    return _right_growth(speed, locked, front=front, rear=rear, **car) * (front != rear)
