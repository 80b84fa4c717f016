"""The acceleration is a rate over omega, which is 0/0 at rest.

fails: energy_gives_the_acceleration_at_rest
names: energy_balance (result 1) returned NaN or infinity
"""

def energy_balance(theta, omega, *, mass, length, gravity):
    inertia, weight = mass * length**2, mass * gravity * length
    rate = weight * np.sin(theta) * omega
    return -rate / np.float64(inertia * omega), inertia * omega**2 / 2, weight * (1 - np.cos(theta))
