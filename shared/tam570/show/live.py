"""Interactive scenes: the equations of motion, the drawing and the handles, as JavaScript that runs in the page.

Their functions are called once with symbols for state, parameters and pointer position; `tam570.integrate` records what
they compute, as for its compiler. If a function cannot be traced, the scene is not interactive.
"""

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field

import numpy as np

from tam570.integrate.course import STAND_INS
from tam570.integrate.formulas import written
from tam570.integrate.trace import FUNCTIONS, Graph, Untraceable, Value, traced
from tam570.loading import Trouble
from tam570.show.compact import shape_entry
from tam570.show.scene import Shape
from tam570.values import Function, Json, Numbers, Parameters

IN_JAVASCRIPT = [name for name in dict.fromkeys(FUNCTIONS.values()) if name not in ("fabs", "erf", "erfc")] + ["pow"]
OPERATIONS = {*IN_JAVASCRIPT, "fabs", "+", "-", "*", "/", "neg"}
NAMED = {"inf": "Infinity", "-inf": "-Infinity", "nan": "NaN"}
LEAST, MOST = 0.25, 3.0  # of a slider, relative to the parameter's value
CLOSE = 1e-9  # relative, between the traced equations and the function: rounding


@dataclass(frozen=True)
class Handle:
    """A point that the user can drag.

    point : point(state, **parameters) -> 2 or 3 numbers, m: its position
    grab  : grab(point, state, **parameters) -> the state with the handle at this position
    """

    point: Function
    grab: Function


@dataclass(frozen=True)
class Live:
    """The equations of an interactive scene, for its first panel.

    rates     : rates(t, state, **parameters) -> the state's rates
    drawing   : drawing(states, parameters) -> Shapes, as for a scene of one sample, states (1, k)
    handles   : points that can be dragged
    measures  : by name, f(state, **parameters) -> J, to plot over time
    conserved : whether the first measure keeps its value
    rests     : whether friction ends the motion, when the first measure is zero
    backdrop  : fixed shapes behind the drawing
    """

    rates: Function
    parameters: Parameters
    start: Sequence[float]
    drawing: Callable[[Numbers, Parameters], Sequence[Shape]]
    handles: Sequence[Handle] = ()
    measures: Mapping[str, Function] = field(default_factory=dict)
    conserved: bool = True
    rests: bool = False
    backdrop: Sequence[Shape] = ()


def drag(first: int, count: int) -> Handle:
    """Return a handle that sets `count` coordinates of the state, from `first` on, and keeps the others."""
    return Handle(
        lambda state, **parameters: state[first : first + count],
        lambda point, state, **parameters: [*state[:first], *point[:count], *state[first + count :]],
    )


def energies(energy: Function, positions: int | None = None) -> dict[str, Function]:
    """Return measures of a state: its energy, and its potential energy, which is the energy with the rates set to 0.

    energy    : energy(state, **parameters) -> J
    positions : number of the coordinates, which come first in a state; None if all energy is kinetic
    """

    def total(state: Numbers, **parameters: Numbers) -> Numbers:
        return energy(np.array(state), **parameters)

    def potential(state: Numbers, **parameters: Numbers) -> Numbers:
        return energy(np.array([*state[:positions], *[0.0] * len(state[positions:])]), **parameters)

    return {"total E": total} | ({"potential V": potential} if positions else {})


def live_if_written(make: Callable[[], Live]) -> Live | None:
    """Return the interactive scene; None if the student's module lacks a function that it needs."""
    try:
        return make()
    except Trouble:
        return None


def program(live: Live) -> tuple[str, Json] | None:
    """Write an interactive scene as JavaScript, with its data; return None if its functions cannot be traced.

    The code has no text from a student's file. If a function needs the value of a parameter, all parameters are
    constants, without sliders.
    """
    sliders = _sliders(live.parameters)
    for chosen in (sliders, [])[: 1 + bool(sliders)]:
        try:
            return _Writer(live, chosen).program()
        except Untraceable:
            continue
    return None


def _sliders(parameters: Parameters) -> list[tuple[str, int | None, float]]:
    """Return name, index in a tuple or None, and value of each number that a slider can change."""
    result: list[tuple[str, int | None, float]] = []
    for name, value in parameters.items():
        if isinstance(value, float):
            result.append((name, None, value))
        elif np.ndim(value) == 1 and np.asarray(value).dtype.kind == "f":
            result += [(name, i, float(element)) for i, element in enumerate(value)]
    return result


class _Writer:
    """Traces one interactive scene; the symbols are the state, the parameters, and the pointer's position."""

    def __init__(self, live: Live, sliders: Sequence[tuple[str, int | None, float]]) -> None:
        self.live, self.sliders, self.k, self.m = live, sliders, len(live.start), len(sliders)

    def program(self) -> tuple[str, Json]:
        rates, drawing = self.live.rates, self.live.drawing  # a trace follows functions in a closure
        of_rates = self._traced(lambda t, state, arguments, pointer: rates(t, state, **arguments))
        self._compare(of_rates)
        still = self.live.backdrop
        measures = {name: measure for name, measure in self.live.measures.items() if self._is_traceable(measure)}
        more = _composed([*(handle.point for handle in self.live.handles), *measures.values()])
        grabs = _composed([handle.grab for handle in self.live.handles])

        def drawn(t: Numbers, state: Numbers, parameters: Parameters, target: Numbers) -> list[Numbers]:
            _, points = _packed([*still, *drawing(np.reshape(state, (1, -1)), parameters)])
            return points + more((state,), parameters)

        def grabbed(t: Numbers, state: Numbers, parameters: Parameters, target: Numbers) -> list[Numbers]:
            return grabs((target, state), parameters)

        graphs = {"rates": of_rates, "drawn": self._traced(drawn), "grab": self._traced(grabbed)}
        code = ",".join(f"{name}(t,s,p,q){{{_body(graph, self.k, self.m)}}}" for name, graph in graphs.items())
        shapes, points = _packed([*still, *drawing(np.reshape(self.live.start, (1, -1)), self.live.parameters)])
        first = len(points)
        count = len(graphs["drawn"].rates) - first - len(measures)
        of_math = f"const {{{','.join(IN_JAVASCRIPT)}}} = Math, fabs = Math.abs;"
        code = f"const program = (() => {{ {of_math} return {{{code}}}; }})();"
        dim = count // max(len(self.live.handles), 1)
        has_first = [*measures][:1] == [*self.live.measures][:1] != []
        data = {
            "start": [float(number) for number in self.live.start],
            "parameters": [
                {
                    "name": name if i is None else f"{name} {i + 1}",
                    "value": value,
                    "range": sorted((LEAST * value, MOST * value)) if value else (-1.0, 1.0),
                }
                for name, i, value in self.sliders
            ],
            "shapes": shapes,
            "handles": [{"at": first + i * dim, "dim": dim} for i in range(len(self.live.handles))],
            "measures": [*measures],
            "first": first + count,
            "constant": has_first and self.live.conserved,
            "rests": has_first and self.live.rests,
        }
        return code, data

    def _is_traceable(self, measure: Function) -> bool:
        try:
            self._traced(lambda t, state, parameters, target: [measure(state, **parameters)])
        except Untraceable:
            return False
        return True

    def _traced(self, function: Function) -> Graph:
        def flat(t: Numbers, symbols: Numbers) -> Numbers:
            parameters = self._known(symbols[self.k : self.k + self.m])
            return function(t, symbols[: self.k], parameters, symbols[self.k + self.m :])

        return traced(flat, self.k + self.m + 3, STAND_INS)

    def _known(self, numbers: Sequence[Numbers]) -> Json:
        """Return the parameters, with the values of sliders replaced by these numbers."""
        parameters = dict(self.live.parameters)
        for (name, i, _), number in zip(self.sliders, numbers, strict=True):
            if i is None:
                parameters[name] = number
            else:
                parameters[name] = (*parameters[name][:i], number, *parameters[name][i + 1 :])
        return parameters

    def _compare(self, graph: Graph) -> None:
        """Raise Untraceable if the graph gives other numbers than the right-hand side that was traced."""
        formulas, constants = written(graph)
        names = {**vars(math), "t": 0.0, **{f"c{i}": number for i, number in enumerate(constants)}}
        for share in (1.0, 1.05):
            state = [share * number + (share - 1.0) for number in self.live.start]
            values = [value for _, _, value in self.sliders]
            wanted = np.array([float(rate) for rate in self.live.rates(0.0, np.array(state), **self.live.parameters)])
            names |= {f"s{i}": number for i, number in enumerate([*state, *values])}
            exec("\n".join(formulas.lines), names)
            result = np.array([eval(rate, names) for rate in formulas.rates])
            if not np.abs(result - wanted).max() <= CLOSE * (1.0 + np.abs(wanted).max()):
                raise Untraceable("its formulas as traced give other numbers than it does")


def _composed(functions: Sequence[Function]) -> Callable[..., list[Numbers]]:
    """Return a function that calls all these with the same arguments and returns their numbers in one list."""
    each = [*functions]  # a trace follows functions in a list

    def composed(arguments: tuple[Numbers, ...], parameters: Parameters) -> list[Numbers]:
        results = [np.ravel(np.array(function(*arguments, **parameters))) for function in each]
        return [number for result in results for number in result.tolist()]

    return composed


def _packed(shapes: Sequence[Shape]) -> tuple[list[Json], list[Value]]:
    """Return the shapes' data for the page, and a list of their coordinates, to whose indices `at` refers."""
    packed, points = list[Json](), list[Value]()
    for shape in shapes:
        rows = shape.points[0] if shape.points.ndim == 3 else shape.points
        dim, at = rows.shape[-1], [len(points) + rows.shape[-1] * i for i in range(len(rows))]
        points += np.ravel(rows).tolist()
        packed.append({"dim": dim, **shape_entry(shape, at)})
    return packed, points


def _body(graph: Graph, k: int, m: int) -> str:
    """Return JavaScript that returns the graph's results, from k numbers of s, m of p, and 3 of q."""
    if missing := {symbol.name for symbol in graph.operations if symbol.arguments} - OPERATIONS:
        raise Untraceable(f"{missing.pop()} is not in JavaScript")
    formulas, constants = written(graph)
    places = [*(f"s[{i}]" for i in range(k)), *(f"p[{i}]" for i in range(m)), *(f"q[{i}]" for i in range(3))]
    numbers = [NAMED.get(repr(number), repr(number)) for number in constants]
    inputs = [f"s{i}={places[i]}" for i in sorted(formulas.reads)]
    declared = [*inputs, *(f"c{i}={number}" for i, number in enumerate(numbers)), *formulas.lines]
    declarations = f"const {','.join(declared)};" if declared else ""
    return f"{declarations}return[{','.join(formulas.rates)}];"
