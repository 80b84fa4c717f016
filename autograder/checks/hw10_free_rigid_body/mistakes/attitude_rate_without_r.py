"""The rate is only omega-hat; it should be R omega-hat.

fails: attitude_follows_omega
"""

def attitude_rate(R, omega):
    p, q, r = omega
    return np.array([[0.0, -r, q], [r, 0.0, -p], [-q, p, 0.0]])
