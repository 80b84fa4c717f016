"""The weight pulls up.

fails: simulate_swings
suspect: the sign of gravity's term missing
"""

def _state_derivative(t, state, *, length, gravity):
    theta, omega = state
    return omega, gravity / length * math.sin(theta)
