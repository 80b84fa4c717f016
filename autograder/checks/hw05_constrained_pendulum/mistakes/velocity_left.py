"""The position mended, the velocity left.

fails: consistent_state_is_the_nearest
suspect: velocity left as it was
"""

def consistent_state(state, *, length):
    distance = math.hypot(state[0], state[1])
    if distance == 0:
        raise ValueError("origin")
    return np.append(state[:2] * length / distance, state[2:])
