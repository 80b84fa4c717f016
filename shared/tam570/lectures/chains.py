"""30 Nov: Chains that fall, are lifted and are poured.

A folded chain hung by one end: the other end, let go beside it, has fallen x. The moving part is (length - x)/2 long.
If the links come to rest inelastically at the fold, no tension acts on it and it falls freely, g. If energy is kept,
(length - x) v^2 = g (2 length x - x^2) + const and its end falls faster, g + v^2/(2 (length - x)): the fold pulls it
down (Wong and Yasui, American Journal of Physics 74, 2006). A chain lifted from a heap takes density v^2 besides its
weight, and half of that work is lost in the heap. A chain let go with its lower end at a scale: its links fall freely,
v^2 = 2 g x, each stops at once, and weight and impact together are three times what lies there.
"""

from collections.abc import Mapping, Sequence
from math import sqrt

import numpy as np

from tam570.given import finite, nonnegative, positive
from tam570.integrate import solve
from tam570.show.scene import Scene, frame_times

__all__ = ["film", "folded", "lifted", "poured"]

EXAMPLE = {"length": 40.0, "density": 1.0, "speed": 8.0, "gravity": 9.81}  # m, kg/m, m/s of lifting, m/s^2

TAUT = 1.18  # times sqrt(length/g): the fall that keeps energy ends at 1.198, at infinite speed


def folded(fallen: float, speed: float, *, length: float, gravity: float) -> tuple[float, float]:
    """(by energy, inelastic) acceleration, m/s^2 downwards, of the end that has fallen, m, at this speed, m/s."""
    positive(length=length)
    finite(speed=speed, gravity=gravity)
    nonnegative(fallen=fallen)
    if fallen >= length:
        raise ValueError(f"fallen: must be less than the length, {length:g} m, where nothing moves; got {fallen!r}")
    return gravity + speed * speed / (2 * (length - fallen)), gravity


def lifted(height: float, speed: float, *, density: float, gravity: float) -> float:
    """N, that lifts the end of a chain of density, kg/m, steadily from a heap; it is at this height, m, now."""
    nonnegative(height=height, speed=speed)
    positive(density=density)
    finite(gravity=gravity)
    return density * (gravity * height + speed * speed)


def poured(fallen: float, *, density: float, gravity: float) -> float:
    """N, that the scale shows while a chain of density, kg/m, has fallen on it by this much, m."""
    nonnegative(fallen=fallen)
    positive(density=density)
    finite(gravity=gravity)
    return 3 * density * gravity * fallen


def film(parameters: Mapping[str, float]) -> Scene:
    """All three at once; the folded one by both of its equations."""
    from tam570.show.scenes.chains import chains

    length, density, speed, gravity = (parameters[name] for name in EXAMPLE)
    positive(length=length, density=density, speed=speed, gravity=gravity)

    def fall(t: float, state: Sequence[float]) -> tuple[float, float]:
        return state[1], folded(state[0], state[1], length=length, gravity=gravity)[0]

    times = frame_times(1.1 * sqrt(2 * length / gravity))
    falling = times[times < TAUT * sqrt(length / gravity)]
    fallen = solve(fall, falling, (0.0, 0.0))[np.minimum(np.arange(len(times)), len(falling) - 1)]
    free = np.minimum(gravity * times**2 / 2, length)
    risen = speed * times
    pull = np.array([lifted(y, speed, density=density, gravity=gravity) for y in risen])
    scale = np.array([poured(x, density=density, gravity=gravity) for x in free])
    scale[free >= length] /= 3  # it lies there
    return chains(times, fallen, free, risen, pull, scale, parameters)
