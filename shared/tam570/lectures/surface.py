"""7 Nov: A particle on a smooth surface, by virtual work.

The surface is z = h(x, y); the constraint force N does no work in any displacement along it, (1, 0, hx) or (0, 1, hy),
so N = lam (-hx, -hy, 1). With m a = N - m g k and z'' = hx x'' + hy y'' + q, q = hxx vx^2 + 2 hxy vx vy + hyy vy^2:
lam = m (g + q)/(1 + hx^2 + hy^2). The particle cannot leave the surface upwards either: it is like a bead on a wire.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import finite, numbers, one_of, positive, sequence
from tam570.integrate import solve
from tam570.show.live import Handle, Live, energies
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, arrow, frame_times
from tam570.values import Numbers, Parameters

STATE = {"x": "m", "y": "m", "vx": "m/s", "vy": "m/s"}
EXAMPLE = {"mass": 1.0, "gravity": 9.81, "surface": "bowl", "curvature": 0.6}  # kg, m/s^2, 1/m
START = (-1.0, 0.4, 1.5, -0.9)
SECONDS = 2.2
SIGNS = {"bowl": (1.0, 1.0), "saddle": (1.0, -1.0), "plane": (0.0, 0.0)}  # of z = c (sx x^2 + sy y^2)/2


def rates(
    t: float, state: Sequence[float], *, mass: float, gravity: float, surface: str, curvature: float
) -> tuple[float, ...]:
    """Return (4,) velocity, m/s, and acceleration, m/s^2, of x and y."""
    lam, hx, hy = _normal(state, mass, gravity, surface, curvature)
    return state[2], state[3], -lam * hx / mass, -lam * hy / mass


def constraint_force(state: ArrayLike, *, mass: float, gravity: float, surface: str, curvature: float) -> Array:
    """Return (3,) N, the force of the surface on the particle, in space, z up."""
    lam, hx, hy = _normal(numbers(4, state=state).tolist(), mass, gravity, surface, curvature)
    return np.array([-lam * hx, -lam * hy, lam])


def energy(state: ArrayLike, *, mass: float, gravity: float, surface: str, curvature: float) -> float:
    """Energy, J; the potential energy is 0 at the height of the origin."""
    x, y, vx, vy = numbers(4, state=state).tolist()
    _, hx, hy = _normal((x, y, vx, vy), mass, gravity, surface, curvature)
    square = vx**2 + vy**2 + (hx * vx + hy * vy) ** 2
    return float(mass * (square / 2 + gravity * height(x, y, surface=surface, curvature=curvature)))


INVARIANTS = {"energy": energy}


def height(x: Numbers, y: Numbers, *, surface: str, curvature: float) -> Numbers:
    """Return z of the surface, m, at x and y, m: floats or arrays."""
    one_of(SIGNS, surface=surface)
    finite(curvature=curvature)
    sx, sy = SIGNS[surface]
    return curvature * (sx * x * x + sy * y * y) / 2


def _normal(
    state: Sequence[float], mass: float, gravity: float, surface: str, curvature: float
) -> tuple[float, float, float]:
    """Return lam, N, and the slopes hx, hy; check every argument."""
    positive(mass=mass)
    finite(gravity=gravity, curvature=curvature)
    one_of(SIGNS, surface=surface)
    sequence(4, state=state)
    x, y, vx, vy = state
    cx, cy = (curvature * sign for sign in SIGNS[surface])
    hx, hy = cx * x, cy * y
    bend = cx * vx * vx + cy * vy * vy
    return mass * (gravity + bend) / (1.0 + hx * hx + hy * hy), hx, hy


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the same start on all three surfaces, the chosen one first."""
    one_of(SIGNS, surface=parameters["surface"])
    times = frame_times(seconds)
    names = sorted(SIGNS, key=lambda name: name != parameters["surface"])
    panels, totals, kinetic = [], {}, {}
    for name in names:
        arguments = {**parameters, "surface": name}
        states = solve(rates, times, start, parameters=arguments)
        forces = np.array([constraint_force(state, **arguments) for state in states])
        unit = 0.4 / (float(np.linalg.norm(forces, axis=1).max()) or 1.0)  # m/N
        particle = np.column_stack(_place(states.T, **arguments))
        force = arrow(particle, unit * forces, 3, "force of the surface")
        panels.append(Panel([*_net(states, arguments), *_draw(states, arguments), force], name))
        totals[name] = values(energy, states, **arguments)
        kinetic[name] = totals[name] - values(energy, states * [1, 1, 0, 0], **arguments)
    largest = max(float(curve.max()) for curve in kinetic.values())
    drift = drift_caption(totals, largest, "the largest kinetic energy")
    net = [shape for shape in panels[0].shapes if shape.points.ndim == 2]
    return Scene(
        "Particle on a surface",
        "A particle slides without friction in a bowl, on a saddle and on a level plane, each time from the same "
        "start. In the bowl it comes back, from the saddle it slides off. An arrow across the surface shows its force.",
        times,
        panels,
        [value_plot("kinetic energy", times, kinetic, "J", *drift)],
        view=(0.9, 0.5),
        still_time=0.4,
        live=Live(rates, parameters, start, _draw, [HANDLE], energies(energy, 2), backdrop=net),
    )


def _place(state: Numbers, *, surface: str, curvature: Numbers, **parameters: Numbers) -> list[Numbers]:
    x, y = state[:2]
    return [x, y, height(x, y, surface=surface, curvature=curvature) + 0.0 * x]


HANDLE = Handle(_place, lambda point, state, **parameters: [point[0], point[1], 0.0, 0.0])


def _draw(states: Array, parameters: Parameters) -> list[Shape]:
    particle = np.column_stack(_place(states.T, **parameters))[:, None]
    return [Shape("trail", particle, 2, "path", width=2), Shape("dot", particle, 0, "particle", width=9)]


def _net(states: Array, parameters: Parameters) -> list[Shape]:
    """Draw the surface as far as the particle goes."""
    low, high = states[:, :2].min(axis=0) - 0.2, states[:, :2].max(axis=0) + 0.2
    net = []
    for i in (0, 1):
        along = np.linspace(low[i], high[i], 25)
        for across in np.linspace(low[1 - i], high[1 - i], 11):
            pair = (along, np.full(25, across))[:: 1 - 2 * i]
            net.append(Shape("path", np.column_stack(_place(pair, **parameters)), GREY, width=1, faint=True))
    return net
