"""A scene: what is simulated and what is drawn, in one record from which a plot, an animation or a benchmark runs."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import NDArray

from tam570.integrate import solve
from tam570.invariants import drift

__all__ = ["Scene"]

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Scene:
    """One motion of one system.

    name       : what to call it
    rhs        : rhs(t, state, **parameters) -> rates
    parameters : keyword arguments of rhs
    start      : (k,) state at times[0]
    times      : (n,) s, where states are wanted
    labels     : of the components of the state, with units
    invariants : by name, each a function of a state: what should not change
    wireframe  : wireframe(state) -> (m, 2, dim) line segments, or None if there is nothing to draw
    """

    name: str
    rhs: Callable[..., Any]
    parameters: Mapping[str, Any]
    start: tuple[float, ...]
    times: Array
    labels: tuple[str, ...] = ()
    invariants: Mapping[str, Callable[[Array], Any]] = field(default_factory=dict)
    wireframe: Callable[[Array], Any] | None = None

    def states(self, *, rtol: float = 1e-10, method: str = "auto") -> Array:
        """(n, k) states at the scene's times."""
        return solve(self.rhs, self.times, self.start, parameters=self.parameters, rtol=rtol, method=method)

    def drifts(self, states: Array) -> dict[str, float]:
        """The largest relative drift of each invariant along these states."""
        return {name: float(drift(value, states).max()) for name, value in self.invariants.items()}

    def frames(self, states: Array) -> Array:
        """(n, m, 2, dim) line segments of these states. ValueError if the scene has nothing to draw."""
        if self.wireframe is None:
            raise ValueError(f"the scene {self.name!r} has no wireframe")
        return np.array([self.wireframe(state) for state in states])
