"""Show that everything from the energy of one coordinate passes, RK45, plain floats and tuples."""

from math import cos, sin

from scipy.integrate import solve_ivp


def contact_inertia(phi, *, mass, radius, offset, inertia):
    return inertia + mass * (radius**2 + offset**2 - 2 * radius * offset * cos(phi))


def slope_of_inertia(phi, mass, radius, offset):
    return 2 * mass * radius * offset * sin(phi)


def slope_of_potential(phi, mass, radius, offset, slope, gravity):
    return mass * gravity * (-(radius - offset * cos(phi)) * sin(slope) + offset * sin(phi) * cos(slope))


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return slope_of_inertia(phi, mass, radius, offset) * phi_dot**2 / 2


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    pull = -slope_of_potential(phi, mass, radius, offset, slope, gravity)
    IC = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)
    return (pull - missing_moment(phi, phi_dot, mass=mass, radius=radius, offset=offset)) / IC


def naive_contact_acceleration(phi, **c):
    return acceleration(phi, 0.0, **c)


def contact_force(phi, phi_dot, **c):
    a, m, r, e = acceleration(phi, phi_dot, **c), c["mass"], c["radius"], c["offset"]
    # polar coordinates of G about the moving centre
    tangential, centripetal = e * a, e * phi_dot**2
    ax = r * a - tangential * cos(phi) + centripetal * sin(phi)
    ay = tangential * sin(phi) + centripetal * cos(phi)
    return m * (ax - c["gravity"] * sin(c["slope"])), m * (ay + c["gravity"] * cos(c["slope"]))


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    x, y = radius * phi - offset * sin(phi), -offset * cos(phi)
    T = contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia) * phi_dot**2 / 2
    return T + mass * gravity * (y * cos(slope) - x * sin(slope))


def simulate(t, phi, phi_dot, **c):
    motion = solve_ivp(
        lambda s, y: (y[1], acceleration(*y, **c)), (t[0], t[-1]), (phi, phi_dot), rtol=1e-9, atol=1e-9, t_eval=t
    )
    return tuple(zip(*motion.y))


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    weight = [mass * gravity * sin(slope), -mass * gravity * cos(slope)]
    return [[[0, -radius], None], [[-offset * sin(phi), -offset * cos(phi)], weight]]
