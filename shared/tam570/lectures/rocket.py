"""30 Nov: A rocket, and what d(m v)/dt = F makes of it.

The momentum balance of the rocket and what it throws out in dt, downwards at `exhaust_speed` u from the rocket, gives m
v' = u b - m g with m' = -b, b the `burn_rate`. So v + u ln m - g m/b is constant while it burns (Meriam, Dynamics,
section 4-7). `wrong_rates` uses the rocket alone as the system, m v' + m' v = -m g: no thrust, and a push that depends
on the observer's speed. The tank is empty at `empty_mass`; then the burning stops. Heights upwards.
"""

from collections.abc import Mapping, Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tam570.arguments import finite, nonnegative, numbers, positive, sequence
from tam570.integrate import solve
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import GREY, Array, Panel, Scene, Shape, frame_times, moving

STATE = {"height": "m", "speed": "m/s", "mass": "kg"}
EXAMPLE = {"burn_rate": 20.0, "exhaust_speed": 1500.0, "empty_mass": 400.0, "gravity": 9.81}  # kg/s, m/s, kg, m/s^2
START = (0.0, 5.0, 600.0)
SECONDS = 18.0


def rates(
    t: float, state: Sequence[float], *, burn_rate: float, exhaust_speed: float, empty_mass: float, gravity: float
) -> tuple[float, float, float]:
    """Return the rates of height, m/s, speed, m/s^2, and mass, kg/s."""
    _check(burn_rate, exhaust_speed, empty_mass, gravity)
    sequence(3, state=state)
    return _moving(state, exhaust_speed, burn_rate, empty_mass, gravity)


def wrong_rates(
    t: float, state: Sequence[float], *, burn_rate: float, exhaust_speed: float, empty_mass: float, gravity: float
) -> tuple[float, float, float]:
    """Return the same by d(m v)/dt = -m g, which is wrong."""
    _check(burn_rate, exhaust_speed, empty_mass, gravity)
    sequence(3, state=state)
    return _moving(state, state[1], burn_rate, empty_mass, gravity)


def _moving(
    state: Sequence[float], pushed_by: float, burn_rate: float, empty_mass: float, gravity: float
) -> tuple[float, float, float]:
    _, speed, mass = state
    if mass > empty_mass:  # else it is empty, or a trial step has burnt more than there is
        return speed, pushed_by * burn_rate / mass - gravity, -burn_rate
    return speed, -gravity, 0.0


def exact(
    t: ArrayLike, state: ArrayLike, *, burn_rate: float, exhaust_speed: float, empty_mass: float, gravity: float
) -> Array:
    """Return (n, 3) states at the times t (n,), s, of the motion that has `state` at t[0], also after the burning."""
    times, (height, speed, mass) = numbers(t=t), numbers(3, state=state).tolist()
    _check(burn_rate, exhaust_speed, empty_mass, gravity)
    positive(**{"state: mass": mass})
    since = times - times[:1]
    fuel = max(mass - empty_mass, 0.0)
    burnt = np.minimum(burn_rate * since, fuel)
    remaining = np.where(burn_rate * since < fuel, mass - burnt, min(mass, empty_mass))
    gained = -exhaust_speed * np.log1p(-burnt / mass)  # by the thrust, m/s
    pushed = exhaust_speed * burnt / burn_rate - remaining * gained / burn_rate  # its integral while it burns, m
    coasting = since - burnt / burn_rate
    risen = height + speed * since - gravity * since**2 / 2 + pushed + gained * coasting
    return np.column_stack([risen, speed + gained - gravity * since, remaining])


def coasting_energy(
    state: ArrayLike, *, burn_rate: float, exhaust_speed: float, empty_mass: float, gravity: float
) -> float:
    """Energy per mass v^2/2 + g h, J/kg, that the rocket has at the end of the burning, and after it."""
    _check(burn_rate, exhaust_speed, empty_mass, gravity)
    height, speed, mass = numbers(3, state=state).tolist()
    parameters = {"burn_rate": burn_rate, "exhaust_speed": exhaust_speed, "empty_mass": empty_mass, "gravity": gravity}
    burning = max(mass - empty_mass, 0.0) / burn_rate  # s
    height, speed, _ = exact([0.0, burning], (height, speed, mass), **parameters)[-1]
    return float(speed**2 / 2 + gravity * height)


INVARIANTS = {"coasting_energy": coasting_energy}


def _check(burn_rate: float, exhaust_speed: float, empty_mass: float, gravity: float) -> None:
    positive(burn_rate=burn_rate, empty_mass=empty_mass)
    nonnegative(exhaust_speed=exhaust_speed)
    finite(gravity=gravity)


def film(parameters: Mapping[str, float], start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of one start by both equations."""
    times = frame_times(seconds)
    correct, wrong = (solve(equations, times, start, parameters=parameters) for equations in (rates, wrong_rates))
    apart = 0.1 * float(np.ptp(np.concatenate([correct[:, 0], wrong[:, 0]])))
    burning = correct[:, 2] > parameters["empty_mass"]
    shapes = [
        Shape("lines", np.array([[-2 * apart, 0.0], [2 * apart, 0.0]]), GREY, "start", width=2),
        *_rocket(correct, -apart, burning, 0, "momentum of rocket and exhaust"),
        *_rocket(wrong, apart, burning, 1, "d(mv)/dt = F of the rocket alone"),
    ]
    energies = values(coasting_energy, correct, **parameters)
    return Scene(
        "Rocket",
        "Two rockets start alike. The right one is pushed by its exhaust until its tank is empty. The other follows "
        "the momentum of what is left in the rocket alone: it has no thrust and falls.",
        times,
        [Panel(shapes)],
        [
            value_plot("speed", times, {"right": correct[:, 1], "wrong": wrong[:, 1]}, "m/s"),
            value_plot("mass", times, {"": correct[:, 2]}, "kg", *drift_caption(energies, about="energy at its end: ")),
        ],
        still_time=0.7,
    )


def _rocket(states: Array, x: float, burning: NDArray[np.bool_], color: int, name: str) -> list[Shape]:
    """Return a dot with its path, and a flame while it burns."""
    positions = np.column_stack([np.full(len(states), x), states[:, 0]])
    flame = positions - np.outer(burning * 0.6 * abs(x), [0.0, 1.0])
    return [
        Shape("trail", positions[:, None], color, width=1.5),
        Shape("lines", moving(positions, flame), 3, width=4),
        Shape("dot", positions[:, None], color, name, width=10),
    ]
