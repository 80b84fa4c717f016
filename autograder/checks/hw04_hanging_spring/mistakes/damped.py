"""A little of the energy is lost at every step.

fails: energy_stays
names: use a tighter tolerance, or a smaller step
numerics: the loss of a method that damps
"""

def simulate(t, position, velocity, *, mass, stiffness, gravity):
    centre = np.array([0, 0, -mass * gravity / stiffness, 0, 0, 0])
    states = solution(t - t[0], position, velocity, mass=mass, stiffness=stiffness, gravity=gravity)
    turned = (t - t[0]) * np.sqrt(stiffness / mass)
    return centre + (states - centre) * np.exp(-5e-7 * turned)[:, None]
