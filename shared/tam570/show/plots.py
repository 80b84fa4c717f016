"""Curves over time beside a motion: values, energies; and what a caption tells of what must not change."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.loading import Trouble
from tam570.show.scene import Array, TimePlot
from tam570.values import Function, Numbers

PLOT_SAMPLES = 400  # of a time plot, which is about as many pixels wide
LARGEST = 1e200  # of what is drawn: its square is a number
LARGE = 1e-3  # a deviation that no careful integration has; 1e-6 is a careless one


def _samples(values: Array) -> NDArray[np.int64]:
    """Return which of the values at all times a time plot needs."""
    count = min(len(values), PLOT_SAMPLES + 1)
    return np.rint(np.linspace(0, len(values) - 1, count)).astype(np.int64)


def value_plot(
    title: str,
    times: Array,
    curves: Mapping[str, ArrayLike],
    unit: str,
    caption: str = "",
    alarm: bool = False,
    *,
    least: float = 0.0,
) -> TimePlot:
    """Plot quantities as they are, from curves at all times; the axis reaches to `least` at least."""
    values = {name: _sampled(curve) for name, curve in curves.items()}
    low = min(0.0, *(float(curve.min()) for curve in values.values()))
    high = max(least, *(float(curve.max()) for curve in values.values()))
    margin = 0.05 * (high - low) or 1.0
    span = low - margin, high + margin
    if not max(map(abs, span)) < LARGEST:
        raise Trouble(f"{title}: the numbers are too large to be drawn")
    return TimePlot(title, _sampled(times), values, span, unit, caption, alarm)


def energy_plot(times: Array, total: Array, potential: Array, title: str = "energy") -> TimePlot:
    """Plot kinetic, potential and total energy; the note tells the drift of the total.

    total, potential : (m,) J
    """
    kinetic = total - potential
    scale = float(np.abs(kinetic).max()) or float(np.abs(total).max())
    curves = {"kinetic T": kinetic, "potential V": potential, "total E": total}
    return value_plot(title, times, curves, "J", *drift_caption(total, scale, "the largest kinetic energy"))


def state_energy_plot(times: Array, states: Array, positions: int, energy: Callable[[Array], ArrayLike]) -> TimePlot:
    """Plot the energies of a motion; without its rates, a state has its potential energy alone.

    states    : (n, k)
    positions : of the state's numbers the first that say where everything is; the rest are rates
    energy    : energy(states (m, k)) -> (m,) J
    """
    shown = _samples(times)
    moving, at_rest = states[shown], states[shown] * (np.arange(states.shape[1]) < positions)
    return energy_plot(times[shown], np.asarray(energy(moving)), np.asarray(energy(at_rest)))


def values(function: Function, states: Array, **parameters: Numbers) -> Array:
    """(m, ...) what `function(state, **parameters)` returns for the states (n, k) that a time plot needs."""
    return np.array([function(state, **parameters) for state in states[_samples(states)]])


def drift_caption(
    constants: Mapping[str, ArrayLike] | ArrayLike, scale: float | None = None, of: str = "itself", about: str = ""
) -> tuple[str, bool]:
    """Tell the drift of what must not change as one number, and whether it is an alarm.

    constants : (m,) numbers or (m, k) vectors, or several of them by name
    scale, of : what the drift is measured by, 1 where it is 0, and its name; the size at the start by default
    about     : begins the caption
    """
    each = [*constants.values()] if isinstance(constants, Mapping) else [constants]
    scale = float(np.linalg.norm(np.asarray(each[0])[0])) if scale is None else scale
    largest = max(float(np.abs(_deviation(values, scale)).max()) for values in each)
    alarm = largest > LARGE
    return f"{about}{'not conserved: ' if alarm else ''}relative drift {largest:.2g} of {of}", alarm


def gap_caption(
    largest: float, limit: float, of: str = "", about: str = "", warning: str = "they differ: "
) -> tuple[str, bool]:
    """Tell the largest gap between what should agree, and whether it is an alarm: beyond the limit."""
    return f"{about}{warning if largest > limit else ''}at most {largest:.2g}{of}", largest > limit


def _sampled(curve: ArrayLike) -> Array:
    array = np.asarray(curve, dtype=float)
    return array[_samples(array)]


def _deviation(values: ArrayLike, scale: float) -> Array:
    """(m,) difference from the first value, of a vector its size, as a share of the scale."""
    array = _sampled(values)
    with np.errstate(over="ignore"):
        moved: Array = (array - array[0]) / (scale or 1.0)
    return moved if moved.ndim == 1 else np.linalg.norm(moved, axis=1)
