"""31 Oct: A rotation matrix as a state, and how it drifts.

Free body: R' = hat(omega) R and, as H does not change, I omega' = -omega x I omega with I = R diag(inertia) R^T; omega
in space. The nine numbers of R obey six conditions, R^T R = I, that no equation here enforces: each step of a
Runge-Kutta method violates them a little, and the errors add up. `tam570.integrate.solve_rotation` turns R by rotations
only.
"""

from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike

from tam570.arguments import numbers, positives, sequence
from tam570.integrate import solve, solve_rotation
from tam570.invariants import rotation_defect
from tam570.rotations import log
from tam570.show.drawing import brick
from tam570.show.plots import drift_caption, value_plot, values
from tam570.show.scene import Array, Panel, Scene, frame_times
from tam570.show.turning import box_size, in_space, live_body, spin_arrow
from tam570.values import Numbers, Parameters

STATE = {f"R{i}{j}": "1" for i in (1, 2, 3) for j in (1, 2, 3)} | {f"omega_{axis}": "rad/s" for axis in "xyz"}
EXAMPLE = {"inertia": (1.0, 2.0, 2.6)}  # kg m^2, about the principal axes of the body
START = (1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.3, 2.0, 0.4)
SECONDS = 20.0
LOOSE = 1e-6  # rtol of the scene
SEEN = 0.5  # R^T R - I is drawn enlarged to this size at most


def rates(t: float, state: Sequence[float], *, inertia: Sequence[float]) -> tuple[float, ...]:
    """Return (12,) R', 1/s, row by row, and omega', rad/s^2."""
    moments = positives(3, inertia=inertia)
    sequence(12, state=state)
    R, w = [state[0:3], state[3:6], state[6:9]], state[9:12]
    H = _in_space(R, [m * x for m, x in zip(moments, _in_body(R, w), strict=True)])
    torque = _in_body(R, _cross(H, w))
    turned = [_cross(w, column) for column in zip(*R, strict=True)]
    rotated = [number for row in zip(*turned, strict=True) for number in row]
    return (*rotated, *_in_space(R, [x / m for m, x in zip(moments, torque, strict=True)]))


def energy(state: ArrayLike, *, inertia: Sequence[float]) -> float:
    """Kinetic energy, J."""
    return float(angular_momentum(state, inertia=inertia) @ numbers(12, state=state)[9:] / 2)


def angular_momentum(state: ArrayLike, *, inertia: Sequence[float]) -> Array:
    """Angular momentum in space, (3,) kg m^2/s."""
    values = numbers(12, state=state)
    R, omega = values[:9].reshape(3, 3), values[9:]
    return R @ (np.array(positives(3, inertia=inertia)) * (R.T @ omega))


INVARIANTS = {"energy": energy, "angular_momentum": angular_momentum}


def _cross(a: Numbers, b: Numbers) -> tuple[float, ...]:
    return a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]


def _in_space(R: Sequence[Sequence[float]], v: Sequence[float]) -> list[float]:
    return [row[0] * v[0] + row[1] * v[1] + row[2] * v[2] for row in R]


def _in_body(R: Sequence[Sequence[float]], v: Sequence[float]) -> list[float]:
    return _in_space(list(zip(*R, strict=True)), v)


def _drift(times: Array, start: Sequence[float], parameters: Parameters) -> tuple[Array, Array]:
    """Return states, and R^T R - I interpolated between the ends of steps: within a step it has a larger error."""
    ends = [np.array([*start, times[0]])]

    def noted(state: Array) -> Array:
        ends.append(np.array(state))
        return state

    def timed(t: float, state: Sequence[float], *, inertia: Sequence[float]) -> tuple[float, ...]:
        return (*rates(t, state[:12], inertia=inertia), 1.0)

    states = solve(timed, times, ends[0], parameters=parameters, rtol=LOOSE, project=noted)[:, :12]
    R = np.array(ends)[:, :9].reshape(-1, 3, 3)
    strain = (np.swapaxes(R, 1, 2) @ R - np.eye(3)).reshape(-1, 9)
    between = [np.interp(times, np.array(ends)[:, 12], element) for element in strain.T]
    return states, np.transpose(between).reshape(-1, 3, 3)


def film(parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of one body, solved in two ways at a loose tolerance."""
    times, moments = frame_times(seconds), np.array(positives(3, inertia=parameters["inertia"]))
    R0, omega0 = np.reshape(start[:9], (3, 3)), np.array(start[9:])
    log(R0)  # ValueError if it is not a rotation
    states, strain = _drift(times, start, parameters)

    def acceleration(t: float, omega: Array) -> list[float]:
        return [-x / m for m, x in zip(moments, _cross(omega, moments * omega), strict=True)]

    turning, rotations = solve_rotation(acceleration, times, R0.T @ omega0, R0, rtol=LOOSE)
    drifting = states[:, :9].reshape(-1, 3, 3)
    enlarged = 10.0 ** np.floor(np.log10(SEEN / max(float(np.abs(strain).max()), 1e-15)))
    drawn = drifting @ (np.eye(3) + enlarged * strain / 2)
    size, title = box_size(moments), f"drift drawn {enlarged:.0e} times"
    defects = {"rotations": rotation_defect(rotations), "nine numbers": np.abs(strain).max(axis=(1, 2))}
    H, omega = (in_space(rotations, vectors) for vectors in (moments * turning, turning))
    both = {"rotations": H, "nine numbers": values(angular_momentum, states, **parameters)}
    changes = {name: np.linalg.norm(momenta - momenta[0], axis=1) for name, momenta in both.items()}
    drift = drift_caption(H, about="by rotations: ")
    text = f"at the end {defects['nine numbers'][-1]:.1e}, and {defects['rotations'][-1]:.0e} by rotations"
    return Scene(
        "Drifting matrix",
        "One body, solved twice at the same tolerance. As nine numbers the matrix ceases to be a rotation, ever more: "
        "the box, its drift enlarged, changes its shape. Turned by rotations alone it stays a box.",
        times,
        [
            Panel([*brick(drawn, size, 1, "nine numbers"), spin_arrow(states[:, 9:], size, 2)], title, ruler=False),
            Panel([*brick(rotations, size, 0, "rotations"), spin_arrow(omega, size, 2)], "by rotations", ruler=False),
        ],
        [
            value_plot("RᵀR - I, largest element", times, defects, "", text),
            value_plot("angular momentum, change", times, changes, "kg m²/s", *drift),
        ],
        still_time=1.0,
        live=live_body(rates, energy, parameters, start, in_body=False),
    )
