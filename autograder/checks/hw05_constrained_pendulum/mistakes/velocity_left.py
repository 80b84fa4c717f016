"""consistent_state leaves the velocity as it was; it should take the radial part off.

fails: consistent_state_is_the_nearest
"""

def consistent_state(state, *, length):
    distance = math.hypot(state[0], state[1])
    if distance == 0:
        raise ValueError("origin")
    return np.append(state[:2] * length / distance, state[2:])
