"""The velocity is left as it was.

fails: consistent_state_is_the_nearest
"""

def consistent_state(state, *, length):
    distance = math.hypot(state[0], state[1])
    if distance == 0:
        raise ValueError("origin")
    return np.append(state[:2] * length / distance, state[2:])
