"""Plots over time beside a motion: values and energies, with captions about the drift of conserved quantities."""

from collections.abc import Callable, Mapping

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.loading import Trouble
from tam570.show.scene import Array, TimePlot
from tam570.values import Function, Numbers

PLOT_SAMPLES = 400  # of a time plot, about its width in pixels
LARGEST = 1e200  # limit of drawn values, whose squares do not overflow
LARGE = 1e-3  # relative drift beyond that of any careful integration; 1e-6 is a careless one


def _samples(values: Array) -> NDArray[np.int64]:
    """Return the indices of the values that a time plot needs."""
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
    """Plot curves that have a value at each time; the axis includes 0 and `least`. Raise Trouble for huge values."""
    values = {name: _sampled(curve) for name, curve in curves.items()}
    low = min(0.0, *(float(curve.min()) for curve in values.values()))
    high = max(least, *(float(curve.max()) for curve in values.values()))
    margin = 0.05 * (high - low) or 1.0
    span = low - margin, high + margin
    if not max(map(abs, span)) < LARGEST:
        raise Trouble(f"{title}: the numbers are too large to be drawn")
    return TimePlot(title, _sampled(times), values, span, unit, caption, alarm)


def energy_plot(times: Array, total: Array, potential: Array, title: str = "energy") -> TimePlot:
    """Plot kinetic, potential and total energy; the caption has the drift of the total.

    total, potential : (m,) J
    """
    kinetic = total - potential
    scale = float(np.abs(kinetic).max()) or float(np.abs(total).max())
    curves = {"kinetic T": kinetic, "potential V": potential, "total E": total}
    return value_plot(title, times, curves, "J", *drift_caption(total, scale, "the largest kinetic energy"))


def state_energy_plot(times: Array, states: Array, positions: int, energy: Callable[[Array], ArrayLike]) -> TimePlot:
    """Plot the energies of a motion; the potential energy is the energy of a state whose rates are set to zero.

    states    : (n, k)
    positions : number of the coordinates, which come first in a state; the rest are rates
    energy    : energy(states (m, k)) -> (m,) J
    """
    shown = _samples(times)
    moving, at_rest = states[shown], states[shown] * (np.arange(states.shape[1]) < positions)
    return energy_plot(times[shown], np.asarray(energy(moving)), np.asarray(energy(at_rest)))


def values(function: Function, states: Array, **parameters: Numbers) -> Array:
    """Return (m, ...) `function(state, **parameters)` for those of the states (n, k) that a time plot needs."""
    return np.array([function(state, **parameters) for state in states[_samples(states)]])


def drift_caption(
    constants: Mapping[str, ArrayLike] | ArrayLike, scale: float | None = None, of: str = "itself", about: str = ""
) -> tuple[str, bool]:
    """Return a caption with the drift of conserved quantities as one number, and whether it is an alarm.

    constants : (m,) numbers or (m, k) vectors, or several of them by name
    scale, of : unit of the drift, where 0 counts as 1, and its name; default: the size at the start
    about     : beginning of the caption
    """
    each = [*constants.values()] if isinstance(constants, Mapping) else [constants]
    scale = float(np.linalg.norm(np.asarray(each[0])[0])) if scale is None else scale
    largest = max(float(np.abs(_deviation(values, scale)).max()) for values in each)
    alarm = largest > LARGE
    return f"{about}{'not conserved: ' if alarm else ''}relative drift {largest:.2g} of {of}", alarm


def gap_caption(
    largest: float, limit: float, of: str = "", about: str = "", warning: str = "they differ: "
) -> tuple[str, bool]:
    """Return a caption with the largest gap between equal quantities, and whether it is an alarm: above the limit."""
    return f"{about}{warning if largest > limit else ''}at most {largest:.2g}{of}", largest > limit


def _sampled(curve: ArrayLike) -> Array:
    array = np.asarray(curve, dtype=float)
    return array[_samples(array)]


def _deviation(values: ArrayLike, scale: float) -> Array:
    """Return (m,) the difference from the first value, of a vector its norm, divided by the scale."""
    array = _sampled(values)
    with np.errstate(over="ignore"):
        moved: Array = (array - array[0]) / (scale or 1.0)
    return moved if moved.ndim == 1 else np.linalg.norm(moved, axis=1)
