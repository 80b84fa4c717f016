"""7 Sept: Two particles on a line with a rod between them, solved in two ways.

Particle 2 is ahead of particle 1; forces F1 and F2 act along the line. The rod's tension T pulls 1 ahead and 2 back:
m1 a1 = F1 + T, m2 a2 = F2 - T, and the rod's length is constant, a1 = a2. One way solves these three equations for a1,
a2 and T. The other adds the first two, which eliminates T, and finds T = (m1 F2 - m2 F1)/(m1 + m2) afterwards.
"""

from collections.abc import Sequence

import numpy as np

from tam570.arguments import numbers
from tam570.show.plots import value_plot
from tam570.show.scene import GREY, Panel, Scene, Shape, arrow, frame_times, moving
from tam570.values import Numbers, Parameters

EXAMPLE: Parameters = {"masses": (1.0, 2.0), "forces": (3.0, -1.0)}  # kg, N
SECONDS = 6.0  # of the scene


def by_constraint(forces: Sequence[float], *, masses: Sequence[float]) -> tuple[float, float]:
    """Return (acceleration, tension), m/s^2 and N, from three equations at once.

    forces : (2,) N, along the line
    masses : (2,) kg; one of them may be 0
    """
    (F1, F2), (m1, m2) = _checked(forces, masses)
    equations = [[m1, 0.0, -1.0], [0.0, m2, 1.0], [1.0, -1.0, 0.0]]  # for a1, a2, T
    acceleration, _, tension = np.linalg.solve(equations, [F1, F2, 0.0]).tolist()
    return acceleration, tension


def by_elimination(forces: Sequence[float], *, masses: Sequence[float]) -> tuple[float, float]:
    """Return (acceleration, tension), m/s^2 and N, from the sum of the equations, in which the tension cancels."""
    (F1, F2), (m1, m2) = _checked(forces, masses)
    return (F1 + F2) / (m1 + m2), (m1 * F2 - m2 * F1) / (m1 + m2)


def _checked(forces: Sequence[float], masses: Sequence[float]) -> tuple[list[float], list[float]]:
    weights = numbers(2, masses=masses)
    if (weights < 0.0).any() or not weights.any():
        raise ValueError(f"masses: must not be negative, and not both 0, got {masses!r}")
    return numbers(2, forces=forces).tolist(), weights.tolist()


def film(parameters: Parameters) -> Scene:
    """Return the scene of forces that swing to and fro, with the tension by both ways."""
    times = frame_times(SECONDS)
    wave = np.cos(2 * np.pi * times / (SECONDS / 2))
    acceleration, tension = by_elimination(parameters["forces"], masses=parameters["masses"])
    pull = np.max(np.abs([*parameters["forces"], tension])) or 1.0  # N
    x = acceleration * (1.0 - wave) * (SECONDS / (4 * np.pi)) ** 2  # from rest
    reach = max(1.0, float(np.ptp(x)))
    ends = [np.column_stack([x + shift * reach / 2, 0 * x]) for shift in (-1.0, 1.0)]
    ways = [np.column_stack([0.6 * reach * F / pull * wave, 0 * x]) for F in (*parameters["forces"], tension, -tension)]
    above = np.array([0.0, 0.12 * reach])
    shapes = [
        Shape("lines", moving(*ends), GREY, "rod", width=5),
        *(arrow(end + above, way, 1, "forces", 3) for end, way in zip(ends, ways, strict=False)),
        *(arrow(end - above, way, 2, "tension", 3) for end, way in zip(ends, ways[2:], strict=True)),
        *(Shape("dot", end[:, None], 0, "particles", width=9) for end in ends),
    ]
    forces: Numbers = np.outer(wave, parameters["forces"])
    tensions = {
        name: np.array([way(pair, masses=parameters["masses"])[1] for pair in forces])
        for name, way in {"by constraint": by_constraint, "by elimination": by_elimination}.items()
    }
    return Scene(
        "Two particles and a rod",
        "Two particles at the ends of a rod are pushed and pulled along it by forces that swing to and fro. Arrows "
        "show the forces and what the rod does to each particle.",
        times,
        [Panel(shapes, ruler=False)],
        [value_plot("tension", times, tensions, "N", "the two curves are one")],
        still_time=0.02,
    )
