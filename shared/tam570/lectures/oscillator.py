"""31 Aug: A mass on a spring of zero rest length, in space.

The spring is held at the origin; there is no gravity. The force is -k r, so m r'' = -k r for each direction separately,
and r = r0 cos(w t) + (v0/w) sin(w t) with w = sqrt(k/m): an ellipse about the origin, once round in 2 pi/w for every
size (Newton, Principia, book I, propositions 10 and 47). State r, v in space.
"""

from collections.abc import Mapping, Sequence
from math import sqrt

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, positive, sequence
from tam570.integrate import solve
from tam570.show.drawing import axes, circle
from tam570.show.live import Live, drag, energies
from tam570.show.plots import drift_caption, state_energy_plot, value_plot, values
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, frame_times, moving

STATE = {"x": "m", "y": "m", "z": "m", "vx": "m/s", "vy": "m/s", "vz": "m/s"}
EXAMPLE = {"mass": 1.0, "stiffness": 4.0}  # kg, N/m
START = (1.0, 0.0, 0.3, 0.2, 1.2, -0.4)
SECONDS = 10.0


def rates(t: float, state: Sequence[float], *, mass: float, stiffness: float) -> tuple[float, ...]:
    """Return (6,) velocity, m/s, and acceleration -(k/m) r, m/s^2."""
    positive(mass=mass, stiffness=stiffness)
    sequence(6, state=state)
    x, y, z, vx, vy, vz = state
    pull = -stiffness / mass
    return vx, vy, vz, pull * x, pull * y, pull * z


def exact(t: ArrayLike, state: ArrayLike, *, mass: float, stiffness: float) -> Array:
    """Return (n, 6) states at the times t (n,), s, of the motion that has `state` at t[0]."""
    positive(mass=mass, stiffness=stiffness)
    times, start = numbers(t=t), numbers(6, state=state)
    w = sqrt(stiffness / mass)  # rad/s
    c, s = (wave(w * (times - times[:1]))[:, None] for wave in (np.cos, np.sin))
    r, v = start[:3], start[3:]
    return np.hstack([c * r + s * v / w, c * v - s * w * r])


def energy(state: ArrayLike, *, mass: float, stiffness: float) -> float:
    """Energy, J: kinetic, and that of the spring."""
    tensor = orbit_tensor(state, mass=mass, stiffness=stiffness)
    return float(tensor[:3].sum() / 2)


def angular_momentum(state: ArrayLike, *, mass: float, stiffness: float) -> Array:
    """Angular momentum about the origin, (3,) kg m^2/s."""
    positive(mass=mass, stiffness=stiffness)
    r, v = numbers(6, state=state).reshape(2, 3)
    return mass * np.cross(r, v)


def orbit_tensor(state: ArrayLike, *, mass: float, stiffness: float) -> Array:
    """Tensor m v v + k r r, J: (6,) xx, yy, zz, yz, zx, xy. It defines the ellipse; its trace is twice the energy."""
    positive(mass=mass, stiffness=stiffness)
    r, v = numbers(6, state=state).reshape(2, 3)
    tensor = mass * np.outer(v, v) + stiffness * np.outer(r, r)
    return tensor[[0, 1, 2, 1, 2, 0], [0, 1, 2, 2, 0, 1]]


INVARIANTS = {"energy": energy, "angular_momentum": angular_momentum, "orbit_tensor": orbit_tensor}


def film(parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of the solved motion, on the ellipse that its start determines."""
    times = frame_times(seconds)
    states = solve(rates, times, start, parameters=parameters)
    shapes = _draw(states, parameters)
    cross = axes(0.5 * float(np.abs(shapes[0].points).max()))
    tensors = values(orbit_tensor, states, **parameters)
    parts = dict(zip(("xx", "yy", "zz", "yz", "zx", "xy"), tensors.T, strict=True))
    return Scene(
        "Oscillator in space",
        "A mass on a spring with no rest length goes round an ellipse in space. The centre of the ellipse is where the "
        "spring is held. The solved motion stays on the ellipse that its start prescribes.",
        times,
        [Panel([*cross, *shapes])],
        [
            state_energy_plot(times, states, 3, lambda rows: values(energy, rows, **parameters)),
            value_plot("m v v + k r r, a tensor", times, parts, "J", *drift_caption(tensors)),
        ],
        still_time=0.25,
        live=Live(rates, parameters, start, _draw, [drag(0, 3)], energies(energy, 3), backdrop=cross),
    )


def _draw(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
    """Draw the mass, and the ellipse of its first state."""
    mass, w = states[:, :3], np.sqrt(parameters["stiffness"] / parameters["mass"])
    return [
        Shape(
            "path", circle(np.zeros(3), states[0, :3], states[0, 3:] / w), GREY, "exact ellipse", width=5, faint=True
        ),
        Shape("trail", mass[:, None], 2, "path", width=2),
        Shape("lines", moving(np.zeros(3), mass), 0, "spring", width=3),
        Shape("dot", np.zeros((1, 3)), INK, width=4),
        Shape("dot", mass[:, None], 1, "mass", width=9),
    ]
