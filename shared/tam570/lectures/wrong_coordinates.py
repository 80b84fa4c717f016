"""16 Nov: Coordinates that do not exist: q = the integral of omega, for each component in the body.

Free body, L = (I1 w1^2 + I2 w2^2 + I3 w3^2)/2. If there were coordinates q with q' = w, no q would occur in L and
Lagrange's equations would be I w' = 0. But rotations do not commute, so no function of the orientation has these
rates; the right equations are Euler's, I w' = -w x I w (Goldstein, Classical Mechanics, section 5.5). Both conserve the
energy and the size of H; by the wrong ones H turns with the body. The state is R row by row, body to space, and omega
along the body's principal axes.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, positives, sequence
from tam570.integrate import solve
from tam570.rotations import log
from tam570.show.drawing import brick
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import Array, Panel, Scene, arrow, frame_times
from tam570.show.turning import box_size, in_space, live_body, spin_arrow
from tam570.values import Parameters

STATE = {f"R{i}{j}": "1" for i in (1, 2, 3) for j in (1, 2, 3)} | {f"omega_{i}": "rad/s" for i in (1, 2, 3)}
EXAMPLE = {"inertia": (1.0, 2.0, 2.6)}  # kg m^2
START = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.4, 1.6, 0.9)
SECONDS = 10.0


def rates(t: float, state: Sequence[float], *, inertia: Sequence[float]) -> tuple[float, ...]:
    """Return (12,) R' = R hat(omega), 1/s, row by row, and omega', rad/s^2, by Euler's equations."""
    A, B, C = positives(3, inertia=inertia)
    sequence(12, state=state)
    p, q, r = state[9:12]
    return *_turning(state), (B - C) * q * r / A, (C - A) * r * p / B, (A - B) * p * q / C


def wrong_rates(t: float, state: Sequence[float], *, inertia: Sequence[float]) -> tuple[float, ...]:
    """Return (12,) the same R', and omega' = 0 by Lagrange's equations for coordinates that do not exist."""
    positives(3, inertia=inertia)
    sequence(12, state=state)
    return *_turning(state), 0.0, 0.0, 0.0


def energy(state: ArrayLike, *, inertia: Sequence[float]) -> float:
    """Kinetic energy, J."""
    omega = numbers(12, state=state)[9:]
    return float(np.array(positives(3, inertia=inertia)) @ omega**2 / 2)


def angular_momentum(state: ArrayLike, *, inertia: Sequence[float]) -> Array:
    """Angular momentum in space, (3,) kg m^2/s."""
    values = numbers(12, state=state)
    return values[:9].reshape(3, 3) @ (np.array(positives(3, inertia=inertia)) * values[9:])


INVARIANTS = {"energy": energy, "angular_momentum": angular_momentum}


def _turning(state: Sequence[float]) -> list[float]:
    """Return R' = R hat(omega), row by row."""
    p, q, r = state[9:12]
    rows = [state[0:3], state[3:6], state[6:9]]
    return [rate for a, b, c in rows for rate in (b * r - c * q, c * p - a * r, a * q - b * p)]


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of one start, by the right equations and by the wrong ones."""
    times, moments = frame_times(seconds), np.array(positives(3, inertia=parameters["inertia"]))
    log(np.reshape(start[:9], (3, 3)))  # ValueError if it is not a rotation
    both = {
        name: solve(equations, times, start, parameters=parameters)
        for name, equations in {"Euler": rates, "wrong Lagrange": wrong_rates}.items()
    }
    size, first = box_size(moments), angular_momentum(start, **parameters)
    scale = float(np.linalg.norm(first)) or 1.0
    panels, momenta = [], {}
    for color, (name, states) in enumerate(both.items()):
        rotations, omega = states[:, :9].reshape(-1, 3, 3), states[:, 9:]
        momenta[name] = in_space(rotations, moments * omega)
        H = arrow(np.zeros(3), 1.8 * float(size.max()) * momenta[name] / scale, 2, "angular momentum", 3)
        shapes = [*brick(rotations, size, color, "body"), spin_arrow(in_space(rotations, omega), size, 3), H]
        panels.append(Panel(shapes, name, ruler=False))
    across = {name: np.degrees(np.arccos(np.clip(H @ first / scale**2, -1.0, 1.0))) for name, H in momenta.items()}
    energies = {name: values(energy, states, **parameters) for name, states in both.items()}
    drift = drift_caption(energies, about="energy: ")
    spins = {name: states[:, 11] for name, states in both.items()}
    return Scene(
        "Wrong coordinates",
        "Two bodies are thrown alike. By Euler's equations the angular momentum stays where it is. By Lagrange's "
        "equations for coordinates that do not exist it is carried round by the body, with no moment on it.",
        times,
        panels,
        [
            value_plot("angular momentum from where it was", times, across, "°"),
            value_plot("spin about the body's third axis", times, spins, "rad/s", *drift),
        ],
        still_time=0.35,
        live=live_body(rates, energy, parameters, start, in_body=True),
    )
