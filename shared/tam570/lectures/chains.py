"""30 Nov: Chains that fall, are lifted and are poured.

A folded chain hung by one end: the other end, let go beside it, has fallen x. The moving part is (length - x)/2 long.
If links come to rest inelastically at the fold, no tension acts on this part and it falls freely, g. If energy is kept,
(length - x) v^2 = g (2 length x - x^2) + const and its end falls faster, g + v^2/(2 (length - x)): the fold pulls it
down (Wong and Yasui, American Journal of Physics 74, 2006). Nothing in F = m a says which of the two a chain does.

Where links start or stop, their momentum changes by density v^2 a second. Textbooks assume that the chain's tension
supplies all of it at a heap, and a scale all of it at the end of a fall. Both are assumptions: a link that is picked up
by one end pushes the heap with the other, which throws it up (Biggins and Warner, Proceedings of the Royal Society A
470, 2014); one that lands on one end pulls down the chain above it (Grewal, Johnson and Ruina, American Journal of
Physics 79, 2011). So `supplied` is the share of that momentum from the rest of the chain: in the heap, or above the
scale. 0 is the textbook, where half of density v^3 is lost; at 1/2 nothing is lost; a real chain is between.
"""

from math import inf

from tam570.arguments import finite, nonnegative, positive
from tam570.show.scenes import chains, drawn_for

EXAMPLE = {"length": 40.0, "density": 1.0, "speed": 8.0, "gravity": 9.81, "supplied": 0.2}  # m, kg/m, m/s, m/s^2, 1


def folded(fallen: float, speed: float, *, length: float, gravity: float) -> tuple[float, float]:
    """Return (by energy, inelastic) acceleration, m/s^2 downwards, of the end that has `fallen`, m, at `speed`, m/s."""
    positive(length=length)
    finite(speed=speed, gravity=gravity)
    nonnegative(fallen=fallen)
    if fallen >= length:
        raise ValueError(f"fallen: must be less than the length, {length:g} m, where nothing moves; got {fallen!r}")
    return gravity + speed * speed / (2 * (length - fallen)), gravity


def lifted(height: float, speed: float, *, density: float, gravity: float, supplied: float = 0.0) -> float:
    """Return the force, N, that lifts a chain of `density`, kg/m, steadily from a heap, with its end at `height`, m.

    supplied : share of the links' momentum, from 0 to 1, that the heap's push supplies
    """
    nonnegative(height=height, speed=speed)
    positive(density=density)
    finite(gravity=gravity)
    _check_share(supplied)
    return density * (gravity * height + (1 - supplied) * speed * speed)


def poured(fallen: float, *, density: float, gravity: float, supplied: float = 0.0, length: float = inf) -> float:
    """Return the reading of a scale, N, on which a chain of `density`, kg/m, let go just above it, has `fallen`, m.

    supplied : share of the links' momentum, from 0 to 1, that the chain above supplies, which pulls it down
    length   : of the chain, m; that pull hardly accelerates a very long one
    """
    positive(density=density)
    nonnegative(fallen=fallen, gravity=gravity)
    _check_share(supplied)
    square = 2 * gravity * fallen  # of the speed v, m^2/s^2
    if supplied != 0 and length != inf:
        positive(length=length)
        if fallen >= length:
            raise ValueError(f"fallen: must be less than the length, {length:g} m; got {fallen!r}")
        # (length - x) v v' = (length - x) g + supplied v^2 is solved by powers of length - x
        power, remaining = 2 * supplied, 1 - fallen / length
        square = 2 * gravity * length * (remaining**-power - remaining) / (1 + power)
    return density * (gravity * fallen + (1 - supplied) * square)


def _check_share(supplied: float) -> None:
    finite(supplied=supplied)
    if not 0 <= supplied <= 1:
        raise ValueError(f"supplied: must be a share from 0 to 1, got {supplied!r}")


film = drawn_for(chains.film, globals())
