"""Reference functions of hw13, unlike the solution: with the force, from the balances of momentum about G.

Axes: x down the ramp, y off it; a cylinder that rolls down turns clockwise.
"""

import math

import numpy as np

from tam570.integrate import solve
from tam570_grader.checks.diagrams import Force, FreeBody, NotAForce
from tam570_grader.checks.diagrams import weight as gravity_force


def arms(phi, radius, offset):
    """Return G from the contact C, and the first and second derivatives over phi of G from the ramp's origin."""
    c, s = offset * np.cos(phi), offset * np.sin(phi)
    return np.array([-s, radius - c]), np.array([radius - c, s]), np.array([s, c])


def clockwise(r, force):
    return r[1] * force[0] - r[0] * force[1]


def weight(mass, gravity, slope):
    return mass * gravity * np.array([math.sin(slope), -math.cos(slope)])


def balanced(phi, phi_dot, mass, radius, offset, inertia, slope, gravity):
    """Return (phi'', along, normal): m a = weight + contact force, I phi'' = its moment about G."""
    arm, first, second = (it.tolist() for it in arms(phi, radius, offset))
    from_G = -arm[0], -arm[1]  # to C
    pull = weight(mass, gravity, slope).tolist()
    # the force without m first phi''
    of_rates = [mass * it * phi_dot**2 - w for it, w in zip(second, pull, strict=True)]
    phi_ddot = clockwise(from_G, of_rates) / (inertia - mass * clockwise(from_G, first))
    along, normal = (mass * it * phi_ddot + rest for it, rest in zip(first, of_rates, strict=True))
    return phi_ddot, along, normal


def acceleration(*state, **cylinder):
    return balanced(*state, **cylinder)[0]


def contact_force(*state, **cylinder):
    return balanced(*state, **cylinder)[1:]


def contact_inertia(phi, mass, radius, offset, inertia):
    arm = arms(phi, radius, offset)[0]
    return inertia + mass * (arm @ arm)


def naive_contact_acceleration(phi, mass, radius, offset, inertia, slope, gravity):
    moment = clockwise(arms(phi, radius, offset)[0], weight(mass, gravity, slope))
    return moment / contact_inertia(phi, mass, radius, offset, inertia)


def missing_moment(phi, phi_dot, mass, radius, offset):
    """Return what is left of I^C phi'' without weight, where M_C is zero. It is the same for any inertia."""
    inertia = mass * radius**2
    phi_ddot = acceleration(phi, phi_dot, mass=mass, radius=radius, offset=offset, inertia=inertia, slope=0, gravity=0)
    return -contact_inertia(phi, mass, radius, offset, inertia) * phi_ddot


def energy(phi, phi_dot, mass, radius, offset, inertia, slope, gravity):
    """Return the energy, J, also of rows."""
    (x, y), first, _ = arms(phi, radius, offset)
    position = np.array([x + radius * phi, y - radius])  # of G from where the centre is at phi = 0
    inertia_about_C = mass * np.sum(first**2, axis=0) + inertia
    return inertia_about_C * phi_dot**2 / 2 - weight(mass, gravity, slope) @ position


def simulate(t, *start, **cylinder):
    """Return (n, 2) states at t, with errors below 1e-9."""

    def rates(_, state):
        return state[1], acceleration(*state, **cylinder)

    return solve(rates, t, start, rtol=1e-12, method="python")


def rocking_rate(mass, radius, offset, inertia, slope, gravity):
    """Return the rate on level ground, where the inertia is that about C at phi = 0."""
    return math.sqrt(mass * gravity * offset / contact_inertia(0.0, mass, radius, offset, inertia))


def small_rocking(t, phi, phi_dot, **cylinder):
    k = rocking_rate(**cylinder)
    z = (phi - 1j * phi_dot / k) * np.exp(1j * k * (t - t[0]))
    return np.column_stack([z.real, -k * z.imag])


INTO_THE_RAMP = "You drew the normal force into the ramp: this is the force that the cylinder exerts on it."
VERTICAL = "You drew the normal force along the vertical. It is normal to the ramp."
ACROSS_THE_RAMP = "You drew the weight straight into the ramp. It is vertical, and the axes are the ramp's."


def free_body_diagram(phi, mass, radius, offset, slope, gravity):
    """Return the cylinder, from its centre, and its forces: at the contact normal and friction, or an unknown one."""
    contact, down = np.array([0.0, -radius]), weight(1.0, 1.0, slope)
    G, bare = contact + arms(phi, radius, offset)[0], offset == 0
    pull = gravity_force(G, "G", gravity, down)
    normal = Force(
        "the normal force", contact, "the contact", (0.0, 1.0), True, not bare or gravity != 0, reversed=INTO_THE_RAMP
    )
    friction = Force("the friction", contact, "the contact", (1.0, 0.0), acts=not bare or gravity * down[0] != 0)
    both = Force("the force of the ramp", contact, "the contact", push=(0.0, 1.0))
    wrong = NotAForce(VERTICAL, contact, -down, sense=True), NotAForce(ACROSS_THE_RAMP, G, (0.0, -1.0), sense=True)
    corners = radius * np.exp(1j * np.linspace(0.0, 2 * np.pi, 25))
    rim = np.column_stack([corners.real, corners.imag])
    return FreeBody(
        "the cylinder", (pull, normal, friction), [(pull, both)], wrong, np.stack([rim[:-1], rim[1:]], axis=1)
    )
