"""The acceleration lacks the rates of e1, e2, e3, along which the velocity is taken.

fails: contact_force_moves_the_centre
"""


def contact_force(state, *, mass, radius, inertia, gravity):
    _, _, _, tilt, _, yaw_rate, tilt_rate, _ = state
    second = euler_state_derivative(0.0, state, mass=mass, radius=radius, inertia=inertia, gravity=gravity)[5:]
    spin_rate = second[2] + second[0] * math.cos(tilt) - yaw_rate * tilt_rate * math.sin(tilt)
    acceleration = radius * np.array([-spin_rate, 0.0, second[1]]) @ _frame(state)
    return mass * (acceleration + np.array([0.0, 0.0, gravity]))
