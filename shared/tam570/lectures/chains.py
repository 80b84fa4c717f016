"""30 Nov: Chains that fall, are lifted and are poured.

A folded chain hung by one end: the other end, let go beside it, has fallen x. The moving part is (length - x)/2 long.
If the links come to rest inelastically at the fold, no tension acts on it and it falls freely, g. If energy is kept,
(length - x) v^2 = g (2 length x - x^2) + const and its end falls faster, g + v^2/(2 (length - x)): the fold pulls it
down (Wong and Yasui, American Journal of Physics 74, 2006). Nothing in F = m a says which of the two a chain does.

Where links start or stop, their momentum changes by density v^2 a second. Textbooks assume that the chain's own tension
does all of it at a heap, and a scale all of it at the end of a fall. Both are assumptions: a link that is picked up by
one end pushes the heap with the other, which throws it up (Biggins and Warner, Proceedings of the Royal Society A 470,
2014); one that lands on one end pulls down the chain above it (Grewal, Johnson and Ruina, American Journal of Physics
79, 2011). So `supplied` is the share of that momentum that the other chain supplies: the one at rest in the heap, the
one above the scale. 0 is the textbook, where half of density v^3 is lost; at 1/2 nothing is; a real chain is between.
"""

from collections.abc import Callable, Mapping, Sequence
from functools import partial
from math import inf, sqrt

import numpy as np

from tam570.arguments import finite, nonnegative, positive
from tam570.integrate import solve
from tam570.show.scene import Array, Scene, frame_times

__all__ = ["film", "folded", "lifted", "poured"]

EXAMPLE = {"length": 40.0, "density": 1.0, "speed": 8.0, "gravity": 9.81, "supplied": 0.2}  # m, kg/m, m/s, m/s^2, 1

DOWN = 0.99  # of the length: what is pulled down ends at infinite speed


def folded(fallen: float, speed: float, *, length: float, gravity: float) -> tuple[float, float]:
    """(by energy, inelastic) acceleration, m/s^2 downwards, of the end that has fallen, m, at this speed, m/s."""
    positive(length=length)
    finite(speed=speed, gravity=gravity)
    nonnegative(fallen=fallen)
    if fallen >= length:
        raise ValueError(f"fallen: must be less than the length, {length:g} m, where nothing moves; got {fallen!r}")
    return gravity + speed * speed / (2 * (length - fallen)), gravity


def lifted(height: float, speed: float, *, density: float, gravity: float, supplied: float = 0.0) -> float:
    """N, that lifts the end of a chain of density, kg/m, steadily from a heap; it is at this height, m, now.

    supplied : share of the links' momentum, from 0 to 1, that the heap's push supplies
    """
    nonnegative(height=height, speed=speed)
    positive(density=density)
    finite(gravity=gravity)
    _check_share(supplied)
    return density * (gravity * height + (1 - supplied) * speed * speed)


def poured(fallen: float, *, density: float, gravity: float, supplied: float = 0.0, length: float = inf) -> float:
    """N, that the scale shows while a chain of density, kg/m, let go with its lower end at it has fallen this much, m.

    supplied : share of the links' momentum, from 0 to 1, that the chain above supplies, and is pulled down for
    length   : of the whole chain, m; if very long it hardly feels that pull
    """
    positive(density=density)
    finite(gravity=gravity)
    square = _landing_speed(fallen, length, gravity, supplied) ** 2
    return density * (gravity * fallen + (1 - supplied) * square)


def _landing_speed(fallen: float, length: float, gravity: float, supplied: float) -> float:
    """m/s. (length - x) v v' = (length - x) g + supplied v^2, which has a solution in powers of length - x."""
    nonnegative(fallen=fallen)
    _check_share(supplied)
    if supplied == 0 or length == inf:
        return sqrt(2 * gravity * fallen)
    positive(length=length)
    if fallen >= length:
        raise ValueError(f"fallen: must be less than the length, {length:g} m; got {fallen!r}")
    power, remaining = 2 * supplied, 1 - fallen / length
    return sqrt(2 * gravity * length * (remaining**-power - remaining) / (1 + power))


def _check_share(supplied: float) -> None:
    finite(supplied=supplied)
    if not 0 <= supplied <= 1:
        raise ValueError(f"supplied: must be a share from 0 to 1, got {supplied!r}")


def film(parameters: Mapping[str, float]) -> Scene:
    """Return all three at once, each by its two limits; lifted and poured also with the share `supplied`."""
    from tam570.show.scenes.chains import chains

    length, density, speed, gravity, supplied = (parameters[name] for name in EXAMPLE)
    positive(length=length, density=density, speed=speed, gravity=gravity)
    _check_share(supplied)
    times = frame_times(1.1 * sqrt(2 * length / gravity))
    shares = {"textbook": 0.0, f"supplied {supplied:g}": supplied, "nothing lost": 0.5}
    folds = [_falls(times, partial(folded, length=length, gravity=gravity), i, length) for i in (0, 1)]
    pulls, readings, falls = {}, {}, {}
    for name, share in shares.items():
        arguments = {"density": density, "gravity": gravity, "supplied": share}
        pulls[name] = np.array([lifted(y, speed, **arguments) for y in np.minimum(speed * times, length)])
        falls[name] = _falls(times, partial(_pulled_down, share, length=length, gravity=gravity), 0, length)[:, 0]
        falling = [poured(x, **arguments, length=length) for x in falls[name][falls[name] < length]]
        readings[name] = np.concatenate([falling, np.full(len(times) - len(falling), density * gravity * length)])
    return chains(times, folds, falls, pulls, readings, parameters)


def _pulled_down(share: float, fallen: float, speed: float, *, length: float, gravity: float) -> tuple[float]:
    return (gravity + share * speed * speed / (length - fallen),)


def _falls(times: Array, accelerations: Callable[[float, float], Sequence[float]], which: int, length: float) -> Array:
    """(n, 2) m and m/s, of what falls from rest by one of these accelerations; its whole length at last."""

    def rates(t: float, state: Sequence[float]) -> tuple[float, float]:
        return state[1], accelerations(state[0], state[1])[which]

    def down(t: float, state: Sequence[float]) -> float:
        return state[0] - DOWN * length

    down.terminal = True  # type: ignore[attr-defined]
    motion = solve(rates, times, (0.0, 0.0), events=down)
    falling = motion.states[times[: len(motion.states)] < motion.t[-1]]
    return np.concatenate([falling, np.tile([length, 0.0], (len(times) - len(falling), 1))])
