"""The car is treated as stopped where its speed passes zero, while it still turns.

fails: simulate_glides_without_friction, simulate_comes_to_rest_and_stays
"""

_right = simulate


def simulate(t, state, locked, **car):
    rows = np.array(_right(t, state, locked, **car))
    passed = np.flatnonzero(rows[:-1, 3] * rows[1:, 3] < 0)
    if len(passed):
        row = passed[0] + 1
        rows[row:, :3], rows[row:, 3:] = rows[row, :3], 0.0
    return rows
