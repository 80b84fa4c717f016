"""The lecture `frames`: one motion seen from space and from a turntable, and Foucault's pendulum."""

from collections.abc import Mapping, Sequence
from types import SimpleNamespace

import numpy as np

from tam570.show.drawing import unit_circle
from tam570.show.live import Live, drag
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, arrow, frame_times, moving

EARTH = {"length": 1.0, "gravity": 9.81, "latitude": 0.741, "spin": 0.4}  # m, m/s^2, rad (Ithaca), rad/s: a fast Earth
SPOKES = np.arange(6) * np.pi / 3  # rad


def film(frames: SimpleNamespace, parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of a particle that a spring pulls to the centre of a turntable, without friction.

    frames : functions of the lecture
    """
    times = frame_times(seconds)
    seen = frames.exact(times, start, **parameters)
    spring = bool(parameters["stiffness"])
    space = frames.to_space(times, seen, spin=parameters["spin"])
    rim, jacobi = 1.1 * float(np.hypot(*seen[:, :2].T).max()), frames.jacobi_integral
    measures = {"Jacobi's integral": lambda state, **parameters: jacobi([*state], **parameters)}

    def drawing(states: Array, parameters: Mapping[str, float]) -> list[Shape]:
        return _table(states, np.zeros(len(states)), rim, spring=True)

    table, plane = _table(seen, 0.0 * times, rim, spring), np.degrees(frames.foucault(times, **EARTH))
    return Scene(
        "Turntable and Foucault's pendulum",
        "A particle slides over a turntable. Seen from space it runs on an ellipse or a straight line. Seen from the "
        "turntable its path winds, bent by the forces of Coriolis and of the rotation. Beside it the plane of a "
        "pendulum turns against the Earth's rotation.",
        times,
        [
            Panel([*table, *_forces(frames, seen, parameters, rim)], "seen from the turntable"),
            Panel(_table(space, parameters["spin"] * times, rim, spring), "seen from space"),
            Panel(_pendulum(frames, times), "Foucault's pendulum, from above", ruler=False),
        ],
        [
            _energies(frames, times, seen, parameters),
            value_plot("Foucault: angle of the plane", times, {"": plane}, "degrees"),
        ],
        still_time=0.4,
        live=Live(frames.rates, parameters, start, drawing, [drag(0, 2)], measures),
    )


def _table(states: Array, turned: Array, rim: float, spring: bool) -> list[Shape]:
    """Draw the turntable, turned by (n,) rad, and the particle on it."""
    angles = SPOKES + turned[:, None]
    ends = rim * np.stack([np.cos(angles), np.sin(angles)], axis=-1)
    particle = states[:, :2]
    return [
        Shape("path", rim * unit_circle(61), GREY, width=2),
        Shape("lines", np.stack([np.zeros_like(ends), ends], axis=2).reshape(len(ends), -1, 2), GREY, width=1),
        Shape("trail", particle[:, None], 2, "path", width=2),
        *([Shape("lines", moving(np.zeros(2), particle), INK, "spring", width=1.5)] if spring else []),
        Shape("dot", particle[:, None], 0, "particle", width=8),
    ]


def _forces(frames: SimpleNamespace, seen: Array, parameters: Mapping[str, float], rim: float) -> list[Shape]:
    """Return the inertial forces, which exist only in the frame of the turntable."""
    both = {"Coriolis": frames.coriolis, "centrifugal": frames.centrifugal}
    forces = {name: np.array([force(state, **parameters) for state in seen]) for name, force in both.items()}
    unit = 0.6 * rim / (max(float(np.linalg.norm(force, axis=1).max()) for force in forces.values()) or 1.0)  # m/N
    return [
        arrow(seen[:, :2], unit * force, color, name)
        for color, (name, force) in zip((1, 3), forces.items(), strict=True)
    ]


def _pendulum(frames: SimpleNamespace, times: Array) -> list[Shape]:
    bob, plane = frames.foucault_path(times, **EARTH), frames.foucault(times, **EARTH)
    along = 1.1 * np.column_stack([np.cos(plane), np.sin(plane)])
    ends = 1.1 * np.array([[1.0, 0.0], [0.0, 1.0]])
    return [
        Shape("path", 1.1 * unit_circle(61), GREY, width=2),
        *(Shape("text", end[None], GREY, words=name) for end, name in zip(ends, ("east", "north"), strict=True)),
        Shape("trail", bob[:, None], 2, width=1.2),
        Shape("lines", moving(-along, along), 4, "plane, turned by -spin sin(latitude) t", width=1.5),
        Shape("dot", bob[:, None], 5, "bob", width=8),
    ]


def _energies(frames: SimpleNamespace, times: Array, seen: Array, parameters: Mapping[str, float]) -> TimePlot:
    mass, stiffness, spin = (parameters[name] for name in ("mass", "stiffness", "spin"))
    squares = (seen[:, :2] ** 2).sum(axis=1) / 2
    curves = {
        "kinetic": mass * (seen[:, 2:] ** 2).sum(axis=1) / 2,
        "spring": stiffness * squares,
        "centrifugal": -mass * spin**2 * squares,
        "Jacobi's integral": values(frames.jacobi_integral, seen, **parameters),
    }
    caption = drift_caption(curves["Jacobi's integral"], float(curves["kinetic"].max()), "the largest kinetic energy")
    return value_plot("energies on the turntable", times, curves, "J", *caption)
