"""Show that Cartesian equations with a multiplier pass, and read-only, transposed and zero-dimensional results."""
import numpy as np
import sympy as sy
from scipy.integrate import solve_ivp

def _solve(theta, omega, mass, length, gravity):
    x, y = length * np.sin(theta), -length * np.cos(theta)
    vx, vy = -y * omega, x * omega
    A = np.array([[mass, 0, x], [0, mass, y], [x, y, 0]], order="F")   # lam: constraint force = -lam r
    b = np.array([0, -mass * gravity, -(vx**2 + vy**2)])
    ax, ay, lam = np.linalg.solve(A, b)
    return x, y, vx, vy, ax, ay, lam

def linear_momentum_balance(theta, omega, *, mass, length, gravity):
    x, y, vx, vy, ax, ay, lam = _solve(theta, omega, mass, length, gravity)
    return np.array((x * ay - y * ax) / length**2), np.array(lam * length)

def angular_momentum_balance(theta, omega, *, mass, length, gravity):
    x, y, vx, vy, ax, ay, lam = _solve(theta, omega, mass, length, gravity)
    out = np.array([(x * ay - y * ax) / length**2, mass * (x * vy - y * vx), -x * mass * gravity])
    out.setflags(write=False)
    return out

def energy_balance(theta, omega, *, mass, length, gravity):
    x, y, vx, vy, ax, ay, lam = _solve(theta, omega, mass, length, gravity)
    return [np.asarray((x * ay - y * ax) / length**2), np.asarray(mass / 2 * (vx**2 + vy**2)), np.asarray(mass * gravity * (y + length))]

def power_balance(theta, omega, *, mass, length, gravity):
    x, y, vx, vy, ax, ay, lam = _solve(theta, omega, mass, length, gravity)
    return np.array([[(x * ay - y * ax) / length**2, 0], [-mass * gravity * vy, 0]])[:, 0]

def virtual_work(theta, omega, *, mass, length, gravity):
    x, y, vx, vy, ax, ay, lam = _solve(theta, omega, mass, length, gravity)
    return np.array([-mass * gravity * x, (x * ay - y * ax) / length**2])[::-1]

def lagrangian():
    th, om, m, l, g = [sy.Symbol(n) for n in ("theta", "omega", "m", "l", "g")]
    x, y = l * sy.sin(th), -l * sy.cos(th)
    return m * ((x.diff(th) * om)**2 + (y.diff(th) * om)**2) / 2 - m * g * (y - y.subs(th, 0))

def lagrange_equation():
    th, om, m, l, g = [sy.Symbol(n) for n in ("theta", "omega", "m", "l", "g")]
    L = lagrangian()
    return sy.simplify((sy.diff(L, th) - sy.diff(L, om, th) * om) / sy.diff(L, om, om))

def action(theta, step, *, mass, length, gravity):
    x, y = length * np.sin(theta), -length * np.cos(theta)
    # chords in place of arcs: error O(step^2)
    v2 = (np.diff(x)**2 + np.diff(y)**2) / step**2
    return np.array(step * np.sum(mass * v2 / 2 - mass * gravity * ((y[1:] + y[:-1]) / 2 + length)))

def small_angle_solution(t, theta0, omega0, *, length, gravity):
    from scipy.linalg import expm
    A = np.array([[0, 1], [-gravity / length, 0]])
    return np.asfortranarray([expm(A * x) @ [theta0, omega0] for x in t])

def period(amplitude, *, length, gravity):
    from scipy.special import elliprf
    return np.array(4 * np.sqrt(length / gravity) * elliprf(0, np.cos(amplitude / 2)**2, 1))

def simulate(t, theta0, omega0, *, length, gravity):
    """Cartesian unit circle, angle unwrapped by integrating it as a 5th variable only to count turns."""
    q = gravity / length
    def f(_, s):
        x, y, u, v, turn = s
        r2 = x * x + y * y
        lam = (u * u + v * v - q * y) / r2
        return [u, v, -lam * x, -q - lam * y, (x * v - y * u) / r2]
    s0 = [np.sin(theta0), -np.cos(theta0), np.cos(theta0) * omega0, np.sin(theta0) * omega0, theta0]
    y = solve_ivp(f, (t[0], t[-1]), s0, t_eval=t, method="DOP853", rtol=1e-10, atol=1e-10).y
    ang = np.arctan2(y[0], -y[1])
    ang += 2 * np.pi * np.round((y[4] - ang) / (2 * np.pi))
    om = (y[0] * y[3] - y[1] * y[2]) / (y[0]**2 + y[1]**2)
    out = np.array([ang, om]).T
    out.flags.writeable = False
    return out


def free_body_diagram(theta, omega, *, mass, length, gravity):
    bob = [length * np.sin(theta), -length * np.cos(theta)]
    return [[bob, [0, -mass * gravity]], [bob, [-np.sin(theta), np.cos(theta)]]]
