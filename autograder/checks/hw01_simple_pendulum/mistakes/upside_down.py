"""The sign of gravity's term is missing.

fails: simulate_swings
"""

def _state_derivative(t, state, *, length, gravity):
    theta, omega = state
    return omega, gravity / length * math.sin(theta)
