"""Right: Newton's equations with the contact force as unknowns, solved by numpy; DOP853 of solve_ivp; lists."""

import numpy as np
from scipy.integrate import solve_ivp


def solved(phi, w, m, r, e, I, s, g):
    ax, ay = r - e * np.cos(phi), e * np.sin(phi)  # x'' = ax phi'' + ...
    A = np.array([[m * ax, -1, 0], [m * ay, 0, -1], [I, r - e * np.cos(phi), e * np.sin(phi)]])
    b = [m * g * np.sin(s) - m * e * np.sin(phi) * w**2, -m * g * np.cos(s) - m * e * np.cos(phi) * w**2, 0]
    return np.linalg.solve(A, b)


def acceleration(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    return solved(phi, phi_dot, mass, radius, offset, inertia, slope, gravity)[0]


def contact_inertia(phi, *, mass, radius, offset, inertia):
    G = np.array([-offset * np.sin(phi), radius - offset * np.cos(phi)])
    return np.array(inertia + mass * G @ G)


def naive_contact_acceleration(phi, *, mass, radius, offset, inertia, slope, gravity):
    G = [-offset * np.sin(phi), radius - offset * np.cos(phi), 0]
    W = mass * gravity * np.array([np.sin(slope), -np.cos(slope), 0])
    return -np.cross(G, W)[2] / contact_inertia(phi, mass=mass, radius=radius, offset=offset, inertia=inertia)


def missing_moment(phi, phi_dot, *, mass, radius, offset):
    return np.float64(mass * radius * offset * phi_dot**2 * np.sin(phi))


def contact_force(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    return list(solved(phi, phi_dot, mass, radius, offset, inertia, slope, gravity)[1:])


def energy(phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    v = phi_dot * np.array([radius - offset * np.cos(phi), offset * np.sin(phi)])
    drop = np.array([radius * phi - offset * np.sin(phi), -offset * np.cos(phi)]) @ [np.sin(slope), -np.cos(slope)]
    return mass * v @ v / 2 + inertia * phi_dot**2 / 2 - mass * gravity * drop


def simulate(t, phi, phi_dot, *, mass, radius, offset, inertia, slope, gravity):
    def f(_, y):
        return [y[1], acceleration(y[0], y[1], mass=mass, radius=radius, offset=offset, inertia=inertia, slope=slope, gravity=gravity)]

    return solve_ivp(f, (t[0], t[-1]), [phi, phi_dot], t_eval=t, method="DOP853", rtol=1e-9, atol=1e-9).y.T.tolist()


def free_body_diagram(phi, *, mass, radius, offset, slope, gravity):
    weight = [mass * gravity * np.sin(slope), -mass * gravity * np.cos(slope)]
    return [[[0, -radius], None], [[-offset * np.sin(phi), -offset * np.cos(phi)], weight]]
