"""Gravity's term has the wrong sign.

fails: simulate_swings
"""

def _state_derivative(t, state, *, length, gravity):
    theta, omega = state
    return omega, gravity / length * math.sin(theta)
