"""The lectures that a hand can take hold of: how each is drawn from one state, and what a hand does to it.

What stands still is that of the film. States are (1, k), and may be symbols.
"""

from collections.abc import Callable, Mapping, Sequence
from types import ModuleType
from typing import Any, TypeAlias

import numpy as np

from tam570.show.drawing import brick, circle, coil
from tam570.show.live import Handle, Live
from tam570.show.scene import GREY, INK, Panel, Scene, Shape, moving
from tam570.values import Function, Numbers

__all__ = ["live_lecture"]

State: TypeAlias = Any
Parameters: TypeAlias = Mapping[str, Any]
Shapes: TypeAlias = list[Shape]


def live_lecture(
    module: ModuleType, name: str, parameters: Parameters, start: Sequence[float], scene: Scene
) -> Live | None:
    """Return the lecture of this name as equations, by the functions of a module, which may be a copy.

    None if it has none.
    """
    if name not in DRAWN:
        return None
    draw, handles, at_rest = DRAWN[name](scene)
    still = [shape for shape in scene.panels[0].shapes if shape.points.ndim == 2]

    def panels(states: State, parameters: Parameters) -> list[Panel]:
        return [Panel([*still, *draw(states, parameters)], scene.panels[0].title)]

    return Live(module.rates, parameters, module.STATE, start, panels, handles, _energies(module, at_rest))


def _energies(module: ModuleType, at_rest: int) -> dict[str, Function]:
    """Return the lecture's energy, and what of it is left if the state's numbers from `at_rest` on are 0."""
    energy = getattr(module, "energy", None)
    if energy is None:
        name, law = next(iter(module.INVARIANTS.items()))
        return {name.replace("_", " "): lambda state, **arguments: law([*state], **arguments)}

    def potential(state: State, **parameters: Numbers) -> Numbers:
        return energy([*state[:at_rest], *[0.0] * (len(state) - at_rest)], **parameters)

    measures = {"total E": lambda state, **arguments: energy([*state], **arguments)}
    return {**measures, "potential V": potential} if at_rest else measures


Drawn: TypeAlias = tuple[Callable[[State, Parameters], Shapes], list[Handle], int]


def _throw(first: int, count: int, panel: int = 0) -> Handle:
    """Return a hand that moves the coordinates from `first` on and keeps all else."""
    return Handle(
        lambda state, **parameters: state[first : first + count],
        lambda point, state, **parameters: [*state[:first], *point[:count], *state[first + count :]],
        panel,
    )


def _oscillator(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        mass = states[:, :3]
        return [
            Shape("trail", mass[:, None], 2, "path", width=2),
            Shape("lines", moving(np.zeros(3), mass), 0, "spring", width=3),
            Shape("dot", mass[:, None], 1, "mass", width=9),
        ]

    return draw, [_throw(0, 3)], 3


def _bodies(scene: Scene) -> Drawn:
    flat = scene.panels[0].shapes[0].points.shape[-1] == 2
    n = len(scene.panels[0].shapes) // 2
    dim = 2 if flat else 3

    def draw(states: State, parameters: Parameters) -> Shapes:
        places = np.reshape(states[:, : 3 * n], (1, n, 3))[..., :dim]
        trails = [Shape("trail", places[:, [i]], i % 6, width=2) for i in range(n)]
        return [*trails, *(Shape("dot", places[:, [i]], i % 6, f"body {i + 1}", width=8) for i in range(n))]

    return draw, [_throw(3 * i, dim) for i in range(n)], 3 * n


def _two_masses(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        m1, m2 = parameters["masses"]
        x1, x2 = states[:, 0], states[:, 1]
        first, second, middle = (np.column_stack([x, 0 * x]) for x in (x1, x2, (m1 * x1 + m2 * x2) / (m1 + m2)))
        return [
            Shape("path", coil(first, second, 0.08), GREY, "spring", width=2),
            Shape("dot", first[:, None], 0, "mass 1", width=10),
            Shape("dot", second[:, None], 1, "mass 2", width=10),
            Shape("lines", moving(middle - [0.0, 0.25], middle + [0.0, 0.25]), 2, "centre of mass", width=2),
        ]

    def handle(i: int) -> Handle:
        return Handle(
            lambda state, **parameters: [state[i], 0.0],
            lambda point, state, **parameters: [*state[:i], point[0], *state[i + 1 :]],
        )

    return draw, [handle(0), handle(1)], 2


def _swinging_bar(scene: Scene) -> Drawn:
    def end(state: State, *, length: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [length * np.sin(state[0]), -length * np.cos(state[0])]

    def draw(states: State, parameters: Parameters) -> Shapes:
        tip = np.column_stack(end(states.T, **parameters))
        return [
            Shape("lines", moving(np.zeros(2), tip), 0, "bar", width=7),
            Shape("dot", (tip / 2)[:, None], 2, "G", width=5),
        ]

    return draw, [Handle(end, lambda point, state, **arguments: [np.arctan2(point[0], -point[1]), 0.0])], 1


def _string(scene: Scene) -> Drawn:
    farthest = float(max(np.abs(shape.points[..., :2]).max() for shape in scene.panels[0].shapes)) / 1.1

    def place(state: State, **parameters: Numbers) -> list[Numbers]:
        return [state[0] * np.cos(state[1]), state[0] * np.sin(state[1]), 0.0 * state[0]]

    def draw(states: State, parameters: Parameters) -> Shapes:
        above = np.column_stack(place(states.T))
        below = np.column_stack([0 * above[:, :2], states[:, 0] - 2.2 * farthest])
        return [
            Shape("trail", above[:, None], 2, "path", width=1.5),
            Shape("lines", moving(above, np.zeros(3), np.zeros(3), below), INK, "string", width=2),
            Shape("dot", above[:, None], 0, "mass on the table", width=10),
            Shape("dot", below[:, None], 1, "mass below", width=12),
        ]

    def grab(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        return [np.hypot(target[0], target[1]), np.arctan2(target[1], target[0]), *state[2:]]

    return draw, [Handle(place, grab)], 2


def _sleigh(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        blade, heading = states[:, :2], states[:, 2]
        ahead = np.column_stack([np.cos(heading), np.sin(heading)])
        sideways = np.column_stack([-np.sin(heading), np.cos(heading)])
        size = abs(float(scene.settings.get("offset", 0.4))) or 0.4
        outline = blade[:, None] + size * (SLEIGH[:, :1] * ahead[:, None] + SLEIGH[:, 1:] * sideways[:, None])
        return [
            Shape("trail", blade[:, None], 2, "path of the blade", width=2),
            Shape("path", np.concatenate([outline, outline[:, :1]], axis=1), 0, "sleigh", width=2),
            Shape("lines", moving(blade - 0.3 * size * ahead, blade + 0.3 * size * ahead), 1, "blade", width=5),
            Shape("dot", (blade + parameters["offset"] * ahead)[:, None], 4, "G", width=6),
        ]

    def turn(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        return [*state[:2], np.arctan2(target[1] - state[1], target[0] - state[0]), *state[3:]]

    def nose(state: State, *, offset: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [state[0] + 1.7 * offset * np.cos(state[2]), state[1] + 1.7 * offset * np.sin(state[2])]

    return draw, [_throw(0, 2), Handle(nose, turn)], 0


SLEIGH = np.array([[-0.4, -0.35], [1.3, -0.35], [1.7, 0.0], [1.3, 0.35], [-0.4, 0.35]])  # of offsets


def _top(scene: Scene) -> Drawn:
    from tam570.show.scenes.top import _top as drawn

    def tip(state: State, **parameters: Numbers) -> list[Numbers]:
        psi, theta = state[:2]
        return [np.sin(theta) * np.sin(psi), -np.sin(theta) * np.cos(psi), np.cos(theta)]

    def grab(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        theta = np.arctan2(np.hypot(target[0], target[1]), target[2])
        return [np.arctan2(target[0], -target[1]), theta, state[2], 0.0, 0.0, state[5]]

    return lambda states, arguments: drawn(states, 0, "let go"), [Handle(tip, grab)], 3


def _surface(scene: Scene) -> Drawn:
    from tam570.lectures.surface import SIGNS

    def height(x: Numbers, y: Numbers, *, surface: str, curvature: Numbers, **parameters: Numbers) -> Numbers:
        sx, sy = SIGNS[surface]
        return curvature * (sx * x * x + sy * y * y) / 2

    def place(state: State, **parameters: Numbers) -> list[Numbers]:
        return [state[0], state[1], height(*state[:2], **parameters) + 0.0 * state[0]]

    def draw(states: State, parameters: Parameters) -> Shapes:
        particle = np.column_stack(place(states.T, **parameters))
        return [
            Shape("trail", particle[:, None], 2, "path", width=2),
            Shape("dot", particle[:, None], 0, "particle", width=9),
        ]

    return draw, [Handle(place, lambda target, state, **arguments: [target[0], target[1], 0.0, 0.0])], 2


def _quadratic_drag(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        ball = states[:, :2]
        return [Shape("trail", ball[:, None], 2, "with drag", width=2), Shape("dot", ball[:, None], 2, width=7)]

    return draw, [_throw(0, 2)], 0


def _planet(scene: Scene) -> Drawn:
    r, v = (np.array([scene.settings[f"start.{part}{axis}"] for axis in "xyz"]) for part in ("", "v"))
    normal = np.cross(r, v)
    across = np.cross(normal, r)
    plane = np.array([vector / (np.linalg.norm(vector) or 1.0) for vector in (r, across)])

    def draw(states: State, parameters: Parameters) -> Shapes:
        planet = states[:, :3] @ plane.T
        return [Shape("trail", planet[:, None], 0, width=2), Shape("dot", planet[:, None], 0, "planet", width=7)]

    def grab(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        return [*(np.array(target[:2]) @ plane), *state[3:]]

    return draw, [Handle(lambda state, **arguments: plane @ np.array(state[:3]), grab)], 3


def _frames(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        particle = states[:, :2]
        return [
            Shape("trail", particle[:, None], 2, "path on the turntable", width=2),
            Shape("lines", moving(np.zeros(2), particle), INK, "spring", width=1.5),
            Shape("dot", particle[:, None], 0, "particle", width=8),
        ]

    return draw, [_throw(0, 2)], 0


def _convergence(scene: Scene) -> Drawn:
    def joints(theta: Numbers, lengths: Numbers) -> tuple[Numbers, Numbers]:
        elbow, arm = (n * np.array([np.sin(a), -np.cos(a)]) for n, a in zip(lengths, theta, strict=True))
        return elbow, elbow + arm

    def draw(states: State, parameters: Parameters) -> Shapes:
        elbow, tip = (end[None] for end in joints(states[0, :2], parameters["lengths"]))
        return [
            Shape("trail", tip[:, None], 0, width=1, faint=True),
            Shape("path", moving(np.zeros(2), elbow, tip), 0, "right equations", width=3),
            Shape("dot", moving(elbow, tip), 0, width=7),
        ]

    def grab_elbow(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        return [np.arctan2(target[0], -target[1]), state[1], 0.0, 0.0]

    def grab_tip(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        elbow, _ = joints(state[:2], parameters["lengths"])
        return [state[0], np.arctan2(target[0] - elbow[0], elbow[1] - target[1]), 0.0, 0.0]

    handles = [
        Handle(lambda state, **arguments: joints(state[:2], arguments["lengths"])[0], grab_elbow),
        Handle(lambda state, **arguments: joints(state[:2], arguments["lengths"])[1], grab_tip),
    ]
    return draw, handles, 2


def _truss(scene: Scene) -> Drawn:
    def draw(states: State, parameters: Parameters) -> Shapes:
        n = states.shape[1] // 4
        particles = np.reshape(states[:, : 2 * n], (1, n, 2))
        return [
            Shape("lines", particles[:, np.ravel(parameters["bars"])], 0, "bars", width=2),
            Shape("trail", particles[:, :1], 2, width=1.5),
            Shape("dot", particles, 1, "particles", width=6),
        ]

    count = scene.panels[0].shapes[-1].points.shape[1]
    return draw, [_throw(2 * i, 2) for i in range(count)], 2 * count


def _stiff_impact(scene: Scene) -> Drawn:
    from tam570.show.scenes.stiff_impact import DEPTH, RADIUS

    def place(state: State, **parameters: Numbers) -> list[Numbers]:
        return [0.0 * state[0], state[0] + RADIUS]

    def draw(states: State, parameters: Parameters) -> Shapes:
        x = states[:, 0]
        low = (x - np.abs(x)) / 2
        plate, ball = np.column_stack([0 * x, low]), np.column_stack([0 * x, x + RADIUS])
        rim = circle(ball, [RADIUS, 0.0], [0.0, RADIUS], 33)
        return [
            Shape("path", coil(np.array([[0.0, -DEPTH]]), plate, 0.04), GREY, "spring", width=2),
            Shape("lines", moving(plate - [0.15, 0.0], plate + [0.15, 0.0]), INK, width=3),
            Shape("fill", rim, 0, "ball"),
        ]

    from tam570.show.scenes.stiff_impact import RADIUS as above

    handle = Handle(
        lambda state, **arguments: [0.0 * state[0], state[0] + above],
        lambda target, state, **arguments: [target[1] - above, 0.0],
    )
    return draw, [handle], 1


def _turning(scene: Scene) -> Drawn:
    """Return a free body by its matrix; a hand takes the tip of omega, whose components are in space or in the body."""
    in_space = scene.title.startswith("Drifting")
    moments = np.array(scene.settings["inertia"])
    size = np.sqrt(np.maximum(moments.sum() / 2 - moments, 0.05 * moments.max()))
    reach = (
        1.8 * float(size.max()) / float(np.linalg.norm([scene.settings[f"start.omega_{i}"] for i in AXES[in_space]]))
    )

    def tip(state: State, **parameters: Numbers) -> Numbers:
        omega = np.array(state[9:])
        return reach * (omega if in_space else np.reshape(state[:9], (3, 3)) @ omega)

    def draw(states: State, parameters: Parameters) -> Shapes:
        R = np.reshape(states[:, :9], (1, 3, 3))
        return [
            *brick(R, size, 0, "body"),
            Shape("trail", tip(states[0])[None, None], 1, width=1.2),
            Shape("arrow", moving(np.zeros(3), tip(states[0])[None]), 1, "angular velocity", width=2.5),
        ]

    def grab(target: Numbers, state: State, **parameters: Numbers) -> list[Numbers]:
        omega = np.array(target) / reach
        return [*state[:9], *(omega if in_space else np.reshape(state[:9], (3, 3)).T @ omega)]

    return draw, [Handle(tip, grab)], 0


AXES = {True: "xyz", False: "123"}  # names of omega's components

DRAWN: dict[str, Callable[[Scene], Drawn]] = {
    "bodies": _bodies,
    "convergence": _convergence,
    "drifting_matrix": _turning,
    "frames": _frames,
    "oscillator": _oscillator,
    "planet": _planet,
    "quadratic_drag": _quadratic_drag,
    "sleigh": _sleigh,
    "stiff_impact": _stiff_impact,
    "string": _string,
    "surface": _surface,
    "swinging_bar": _swinging_bar,
    "top": _top,
    "truss": _truss,
    "two_masses": _two_masses,
    "wrong_coordinates": _turning,
}
