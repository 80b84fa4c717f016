"""hw06: two cars brake side by side, one with the front wheels locked, one with the rear wheels."""

from collections.abc import Sequence

import numpy as np

from tam570.loading import Trouble
from tam570.show.diagrams import force_shapes
from tam570.show.drawing import placed, solid
from tam570.show.live import Handle, Live, live_if_written
from tam570.show.plots import drift_caption, value_plot
from tam570.show.scene import GREY, INK, Array, Panel, Scene, Shape, TimePlot, frame_times
from tam570.show.student import StudentModule
from tam570.values import Numbers, Parameters

EXAMPLE = {
    "mass": 1200.0,  # kg
    "yaw_inertia": 1700.0,  # kg m^2
    "front": 1.2,  # m
    "rear": 1.4,  # m
    "friction": 0.7,
    "gravity": 9.81,  # m/s^2
}
CAR = ("mass", "front", "rear", "friction", "gravity")  # what its forces depend on
STATE = {"x": "m", "y": "m", "heading": "rad", "speed": "m/s", "yaw_rate": "rad/s"}
START = (0.0, 0.0, 0.0, 14.0, 0.05)  # almost straight
LANES = {"front": -3.5, "rear": 3.5}  # m
SECONDS = 6.0
HALF_WIDTH, OVERHANG, WHEEL, ARROW = 0.8, 0.7, 0.32, 2.0  # m


def film(student: StudentModule, parameters: Parameters, start: Sequence[float], seconds: float) -> Scene:
    """Return the scene of both cars, which start with the same speed and the same small yaw rate."""
    times = frame_times(seconds)
    car = {name: parameters[name] for name in CAR}
    motions = {locked: student("simulate", times, np.array(start), locked, **parameters) for locked in LANES}
    ends = max(float(states[:, 0].max()) for states in motions.values()) + 4.0
    shapes = [Shape("lines", np.array([[-4.0, y], [ends, y]]), GREY, width=1, faint=True) for y in LANES.values()]
    for locked, states in motions.items():
        shapes += _car(states, locked, LANES[locked], parameters)
        shapes += force_shapes(student, states, [locked] * len(times), size=ARROW, origin=[0.0, LANES[locked]], **car)
    headings = {f"{locked} locked": np.degrees(states[:, 2]) for locked, states in motions.items()}
    return Scene(
        "Braking with one axle locked",
        "Two cars brake side by side. The one with locked front wheels comes to rest pointing ahead; the one with "
        "locked rear wheels swings round.",
        times,
        [Panel(shapes)],
        [
            *student.make_each(lambda: _energy(student, times, motions, parameters)),
            value_plot("heading", times, headings, "°", least=10.0),
        ],
        still_time=0.45,
        live=live_if_written(lambda: _live(student, parameters, start, shapes[:2])),
    )


def _live(student: StudentModule, parameters: Parameters, start: Sequence[float], roads: list[Shape]) -> Live:
    """Return the equations of the car that swings round, with handles that move it and turn it by its nose."""
    derivative, energy = student.function("state_derivative"), student.function("kinetic_energy")
    lane = LANES["rear"]

    def rates(t: float, state: Numbers, **parameters: Numbers) -> Numbers:
        return derivative(t, state, "rear", **parameters)

    def drawing(states: Numbers, parameters: Parameters) -> list[Shape]:
        return _car(states, "rear", lane, parameters)

    def nose(state: Numbers, *, front: Numbers, **parameters: Numbers) -> list[Numbers]:
        reach = front + OVERHANG
        return [state[0] + reach * np.cos(state[2]), state[1] + lane + reach * np.sin(state[2])]

    def turn(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [*state[:2], np.arctan2(point[1] - lane - state[1], point[0] - state[0]), *start[3:]]

    def move(point: Numbers, state: Numbers, **parameters: Numbers) -> list[Numbers]:
        return [point[0], point[1] - lane, state[2], *start[3:]]

    def kinetic(state: Numbers, *, friction: Numbers, gravity: Numbers, **parameters: Numbers) -> Numbers:
        return energy(state, "rear", **parameters)

    handles = [Handle(lambda state, **arguments: [state[0], state[1] + lane], move), Handle(nose, turn)]
    measures = {"kinetic": kinetic}
    return Live(rates, parameters, start, drawing, handles, measures, conserved=False, rests=True, backdrop=roads)


def _car(states: Array, locked: str, y: float, parameters: Parameters) -> list[Shape]:
    nose, tail, side = parameters["front"] + OVERHANG, -parameters["rear"] - OVERHANG, HALF_WIDTH
    body = np.array([[nose - 0.5, side], [tail, side], [tail, -side], [nose - 0.5, -side], [nose, -0.5], [nose, 0.5]])
    color = 0 if locked == "front" else 1
    axles = {"front": parameters["front"], "rear": -parameters["rear"]}
    ends = [(end, aside) for aside in (side - 0.1, 0.1 - side) for end in (-WHEEL, WHEEL)]
    wheels = {name: np.array(ends) + [at, 0.0] for name, at in axles.items()}
    free = "rear" if locked == "front" else "front"
    G, heading = states[:, :2] + [0.0, y], states[:, 2]
    return [
        Shape("trail", G[:, None], color, width=1.5),
        *solid(placed(body, G, heading), color, f"{locked} wheels locked"),
        Shape("lines", placed(wheels[free], G, heading), INK, width=3),
        Shape("lines", placed(wheels[locked], G, heading), 5, "wheels that are locked" if color else "", width=5),
        Shape("text", np.array([[-4.0, y + 1.6]]), color, words=f"{locked} locked"),
    ]


def _energy(student: StudentModule, times: Array, motions: dict[str, Array], parameters: Parameters) -> TimePlot:
    """Plot the kinetic energy; the caption has the drift of its sum with the energy lost to friction."""
    arguments = {name: parameters[name] for name in ("mass", "yaw_inertia", "front", "rear")}
    energies, sums = {}, {}
    for locked, states in motions.items():
        energy = student.each("kinetic_energy", states, [locked] * len(states), **arguments)
        energies[f"{locked} locked"] = energy / 1000
        sums[locked] = energy - _work(student, states, locked, parameters)
    scale = max(abs(float(values[0])) for values in sums.values())
    if not scale:
        raise Trouble("kinetic_energy gives 0 for a car that moves")
    caption = drift_caption(sums, scale, "the energy at the start", "less work of friction: ")
    return value_plot("kinetic energy", times, energies, "kJ", *caption)


def _work(student: StudentModule, states: Array, locked: str, parameters: Parameters) -> Array:
    """Return (n,) J, the work of friction up to each time, by the trapezoidal rule along the locked axle's path."""
    car = {name: parameters[name] for name in CAR}
    force = student.each("friction_force", states, [locked] * len(states), **car)
    c, s = np.cos(states[:, 2]), np.sin(states[:, 2])
    in_space = np.column_stack([c * force[:, 0] - s * force[:, 1], s * force[:, 0] + c * force[:, 1]])
    at = parameters["front"] if locked == "front" else -parameters["rear"]
    steps = np.diff(placed(np.array([[at, 0.0]]), states[:, :2], states[:, 2])[:, 0], axis=0)
    middle = (in_space[1:] + in_space[:-1]) / 2
    return np.concatenate([[0.0], np.cumsum((middle * steps).sum(axis=1))])
