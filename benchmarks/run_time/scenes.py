"""Problems that the reference solutions of assignments pass to the integrator, and other sets of problems."""

import importlib.util
from dataclasses import dataclass
from functools import partial
from pathlib import Path

import numpy as np
from run_time import lectures, literature, public

import tam570.integrate
from tam570.integrate.formulas import written
from tam570.integrate.trace import traced

SOLUTIONS = Path(__file__).parents[2] / "solutions"

G = 9.81  # m/s^2
PI = 3.141592653589793


class _Captured(Exception):
    """Raised in place of the integration, with its arguments."""


def loaded(slug):
    """Load the reference solution of an assignment as a new module."""
    spec = importlib.util.spec_from_file_location(f"_{slug}", SOLUTIONS / f"{slug}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _capture(rhs, t, y0, *, parameters=None, **_):
    raise _Captured(rhs, tuple(float(y) for y in y0), dict(parameters or {}))


@dataclass(frozen=True)
class Call:
    """A call of a solution's simulation."""

    slug: str
    start: tuple
    parameters: dict
    end: float  # s
    function: str = "simulate"

    @property
    def arguments(self):
        return np.array([0.0, self.end]), *self.start

    def of(self, module):
        """Return what the function of a solution returns."""
        return getattr(module, self.function)(*self.arguments, **self.parameters)

    def handed_over(self):
        """Return rhs, y0, parameters and end of the first integration that the solution calls."""
        original = tam570.integrate.solve
        tam570.integrate.solve = _capture
        try:
            self.of(loaded(self.slug))  # loaded here, so that it imports the replaced `solve`
        except _Captured as captured:
            return *captured.args, self.end
        finally:
            tam570.integrate.solve = original
        raise LookupError(f"{self.slug}.{self.function} integrates nothing")


SCENES = {
    "simple pendulum": Call(  # about 200 periods of 2 pi sqrt(l/g) and 100 of an amplitude of 3 rad
        "hw01_simple_pendulum", (3.0, 0.0), {"length": 9.81, "gravity": G}, 100 * 10.1
    ),
    "ballistics": Call("hw02_ballistics", (50.0, 0.8), {"mass": 0.5, "drag": 0.1, "gravity": G}, 20.0),
    "hanging spring": Call(
        "hw04_hanging_spring",
        ([1.0, 0.2, -0.5], [0.3, -1.0, 0.4]),
        {"mass": 1.0, "stiffness": 7.0, "gravity": G},
        100.0,
    ),
    "constrained pendulum": Call(
        "hw05_constrained_pendulum", ([1.0, 0.0, 0.0, 0.0],), {"mass": 1.0, "length": 1.0, "gravity": G}, 100.0
    ),
    "braking car": Call(
        "hw06_braking",
        ([0.0, 0.0, 0.1, 25.0, 0.05], "rear"),
        {"mass": 1200.0, "yaw_inertia": 1500.0, "front": 1.1, "rear": 1.5, "friction": 0.8, "gravity": G},
        4.0,  # stops later
    ),
    "double pendulum": Call(
        "hw07_double_pendulum",
        ([PI / 2, PI / 2], [0.0, 0.0]),
        {"masses": (1.0, 1.0), "lengths": (1.0, 1.0), "gravity": G},
        10.0,
    ),
    "free rigid body": Call(
        "hw10_free_rigid_body", (np.eye(3).tolist(), [0.1, 1.0, 0.2]), {"inertia": (1.0, 2.0, 3.0)}, 100.0
    ),
    "bead on wire": Call("hw12_bead_on_wire", (2.0, 0.0), {"curvature": 0.5, "gravity": G}, 100.0),
    "rolling cylinder": Call(
        "hw13_rolling_cylinder",
        (0.3, 0.0),
        {"mass": 2.0, "radius": 0.5, "offset": 0.2, "inertia": 0.15, "slope": 0.1, "gravity": G},
        20.0,
    ),
    "rolling disk": Call(
        "hw14_rolling_disk",
        ([0.0, 0.0, 0.0, 1.2, 0.0, 0.5, 0.1, 8.0],),
        {"mass": 1.0, "radius": 0.5, "inertia": (0.0625, 0.125), "gravity": G},
        10.0,
        function="simulate_euler",
    ),
}


SMOOTH = [name for name in lectures.PROBLEMS if name != "rocket"]  # no reference by series past its burnout
OTHERS = {**public.PROBLEMS, **literature.PROBLEMS}
# add a row for another set
SETS = {
    "scenes": list(SCENES),
    "public": list(public.PROBLEMS),
    "literature": list(literature.PROBLEMS),
    "lectures": SMOOTH,
}


def scene(name):
    """Return (rhs, start, parameters, end) of a scene; states at `end`, s, are compared."""
    if name in SCENES:
        return SCENES[name].handed_over()
    if name in lectures.PROBLEMS:
        return lectures.PROBLEMS[name]
    rhs, start, end = OTHERS[name]
    return rhs, start, {}, end


def formulas_of(scene):
    """Return the traced right-hand side of a scene as formulas, and their constants."""
    rhs, start, parameters, _ = scene
    return written(traced(partial(rhs, **parameters), len(start)))
