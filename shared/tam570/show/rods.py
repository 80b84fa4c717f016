"""Rods that hang one below the other from the origin, at angles from straight down: pendulums, single and double."""

from collections.abc import Callable, Sequence

import numpy as np

from tam570.show.live import Handle
from tam570.values import Numbers, Parameters


def joints(angles: Numbers, lengths: Sequence[Numbers]) -> list[Numbers]:
    """Return the lower end of each rod, (..., 2) m, from angles of any shape (...), rad; they may be symbols."""
    ends, at = [], np.zeros(2)
    for angle, length in zip(angles, lengths, strict=False):
        at = at + np.stack([length * np.sin(angle), -length * np.cos(angle)], axis=-1)
        ends.append(at)
    return ends


def rod_handles(count: int, lengths: Callable[[Parameters], Sequence[Numbers]]) -> list[Handle]:
    """Return the handles that turn each rod about its upper end; after a drag all rods are at rest.

    count   : number of rods; the state is their angles, then their rates
    lengths : lengths(parameters) -> the rods' lengths
    """

    def handle(i: int) -> Handle:
        def end(state: Numbers, **parameters: Numbers) -> Numbers:
            return joints(state[:count], lengths(parameters))[i]

        def turn(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
            x, y = joints(state[:i], lengths(parameters))[-1] if i else (0.0, 0.0)
            return [*state[:i], np.arctan2(point[0] - x, y - point[1]), *state[i + 1 : count], *[0.0] * count]

        return Handle(end, turn)

    return [handle(i) for i in range(count)]
