"""attitude_rate is omega-hat.

fails: attitude_follows_omega
suspect: omega-hat alone
"""

def attitude_rate(R, omega):
    p, q, r = omega
    return np.array([[0.0, -r, q], [r, 0.0, -p], [-q, p, 0.0]])
