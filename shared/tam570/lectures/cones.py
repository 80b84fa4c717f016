"""19 Oct: A symmetric body without forces: its body cone rolls on the space cone.

`axial` and `transverse` are the moments of inertia, `spin` and `wobble` the parts of omega along the axis and across
it. In the body, omega goes round the axis at (axial - transverse) spin/transverse; in space, the axis and omega go
round the angular momentum H at |H|/transverse (Goldstein, Classical Mechanics, section 5.6). Space: z along H; the
axis of the body starts in the plane of x and z, on the side of x.
"""

from collections.abc import Mapping
from math import atan2, hypot

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import array, finite, positive
from tam570.show.drawing import circle, cone
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, arrow, frame_times, moving, with_slider

EXAMPLE = {"axial": 2.0, "transverse": 1.1, "spin": 2.0, "wobble": 1.2}  # kg m^2, rad/s
SHAPES = (0.4, 1.4)  # axial, of the scene's slider; from a rod to a disk


def omega(t: ArrayLike, *, axial: float, transverse: float, spin: float, wobble: float) -> Array:
    """Return omega in space, (n, 3) rad/s, at the times t (n,), s; or (3,) at one time."""
    along, across = _momentum(axial, transverse, spin, wobble)
    H = hypot(along, across) or 1.0
    out, up = (spin * across - wobble * along) / H, (spin * along + wobble * across) / H
    return _round(t, out, up, hypot(along, across) / transverse)


def axis(t: ArrayLike, *, axial: float, transverse: float, spin: float, wobble: float) -> Array:
    """Return the unit vector along the axis of the body, in space, (n, 3); or (3,) at one time."""
    along, across = _momentum(axial, transverse, spin, wobble)
    angle = atan2(across, along)
    return _round(t, np.sin(angle), np.cos(angle), hypot(along, across) / transverse)


def body_cone(*, axial: float, transverse: float, spin: float, wobble: float) -> float:
    """Return the half-angle from the axis to omega, rad, in [0, pi]. Raise ValueError for a body at rest."""
    _momentum(axial, transverse, spin, wobble, moving=True)
    return atan2(abs(wobble), spin)


def space_cone(*, axial: float, transverse: float, spin: float, wobble: float) -> float:
    """Return the half-angle from H to omega, rad, in [0, pi/2). Raise ValueError for a body at rest."""
    along, across = _momentum(axial, transverse, spin, wobble, moving=True)
    return atan2(abs(spin * across - wobble * along), spin * along + wobble * across)


def precession_rate(*, axial: float, transverse: float, spin: float, wobble: float) -> float:
    """Return the rate, rad/s, at which axis and omega go round H in space."""
    return hypot(*_momentum(axial, transverse, spin, wobble)) / transverse


def body_rate(*, axial: float, transverse: float, spin: float, wobble: float) -> float:
    """Return the size of the rate, rad/s, at which omega goes round the axis in the body.

    Its direction is that of the spin for a flat body (axial > transverse), opposite for a long one.
    """
    _momentum(axial, transverse, spin, wobble)
    return abs((axial - transverse) * spin) / transverse


def _momentum(axial: float, transverse: float, spin: float, wobble: float, moving: bool = False) -> tuple[float, float]:
    """Return the angular momentum along the axis and across it, kg m^2/s; check every argument."""
    positive(axial=axial, transverse=transverse)
    finite(spin=spin, wobble=wobble)
    if moving and spin == wobble == 0.0:
        raise ValueError("spin, wobble: both are 0, and a body at rest has no cones")
    return axial * spin, transverse * wobble


def _round(t: ArrayLike, out: float, up: float, rate: float) -> Array:
    """Return (..., 3) a vector that goes round z at this rate."""
    turned = rate * array(None, t=t)
    return np.stack([out * np.cos(turned), out * np.sin(turned), up + 0.0 * turned], axis=-1)


def film(parameters: Mapping[str, float]) -> Scene:
    """Return the scene of the body, with a slider that changes it from a rod to a disk."""
    name = "moment of inertia about the axis"
    return with_slider(lambda C: _film({**parameters, "axial": C}), name, "kg m²", SHAPES, parameters["axial"])


def _film(parameters: Mapping[str, float]) -> Scene:
    times = frame_times(8.0)
    turning, along = omega(times, **parameters), axis(times, **parameters)
    axial, transverse, spin = (parameters[name] for name in ("axial", "transverse", "spin"))
    across = np.cross([0.0, 0.0, 1.0], along)
    across /= np.linalg.norm(across, axis=1, keepdims=True) + 1e-300
    other = np.cross(along, across)
    turned = spin * (1 - axial / transverse) * times[:, None]  # in the body, from the plane of H and the axis
    first, second = (np.cos(turned) * across + np.sin(turned) * other, np.cos(turned) * other - np.sin(turned) * across)
    scale = 1.0 / hypot(spin, parameters["wobble"])
    tip, wide = scale * turning, scale * abs(parameters["wobble"])
    space_rim = circle([0.0, 0.0, tip[0, 2]], [tip[0, 0], 0.0, 0.0], [0.0, tip[0, 0], 0.0], 37)
    H = transverse * turning + (axial - transverse) * np.einsum("ni,ni->n", turning, along)[:, None] * along
    omegas = dict(zip("xyz", turning.T, strict=True))
    drift = drift_caption(H, float(H[0, 2]), "the angular momentum")
    return Scene(
        "Free symmetric body",
        "A cone fixed in the body rolls without slip on a cone fixed in space. They touch along the angular velocity. "
        "A long body's cone rolls on the outside, a flat body's cone holds the other inside it.",
        times,
        [
            Panel(
                [
                    *cone(space_rim, 2, "space cone"),
                    *cone(circle(scale * spin * along, wide * first, wide * second, 37), 0, "body cone"),
                    Shape("path", circle(np.zeros(3), 0.5 * first, 0.5 * second), GREY, "the body", width=3),
                    Shape("lines", moving(0.5 * first, -0.5 * first), GREY),
                    arrow(np.zeros(3), 1.2 * tip, 1, "angular velocity", 3),
                    Shape("arrow", np.array([[0.0, 0.0, 0.0], [0.0, 0.0, 1.3]]), 4, "angular momentum", width=3),
                ],
                ruler=False,
            )
        ],
        [value_plot("angular velocity in space", times, omegas, "rad/s", *drift)],
        view=(0.5, 0.3),
        still_time=0.1,
    )
