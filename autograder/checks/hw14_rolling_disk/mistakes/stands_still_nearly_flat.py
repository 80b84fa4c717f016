"""Both simulations stop where the tilt is below 0.1.

fails: euler_simulation_follows_the_motion, matrix_simulation_follows_the_motion
"""

_euler, _matrix = simulate_euler, simulate_matrix


def until(low, rows):
    for row in range(1, len(rows)):
        if low(rows[row]):
            rows[row] = rows[row - 1]
    return rows


def simulate_euler(t, state, **disk):
    return until(lambda row: row[3] < 0.1, np.array(_euler(t, state, **disk)))


def simulate_matrix(t, state, **disk):
    return until(lambda row: row[2] < 0.1 * disk["radius"], np.array(_matrix(t, state, **disk)))
