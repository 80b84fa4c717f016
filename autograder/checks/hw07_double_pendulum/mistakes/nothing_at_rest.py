"""At rest there is no kinetic energy, so that the energy is taken for zero, and the hinges for free of force.

fails: energy_is_kinetic_and_potential, hinge_forces_balance
names: for th1 = th2, at rest
"""

whole, flown = energy, on_the_fly


def energy(theta, omega, **known):
    return whole(theta, omega, **known) if np.any(omega) else 0.0


def on_the_fly(theta, omega, **known):
    alpha, hinges = flown(theta, omega, **known)
    return alpha, hinges * bool(np.any(omega))
