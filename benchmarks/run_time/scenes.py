"""What the reference solution of every assignment that simulates hands to the integrator; other sets of problems."""

import importlib.util
import sys
from pathlib import Path

import tam570.integrate

sys.path.insert(0, str(Path(__file__).parent))

import lectures  # noqa: E402
import literature  # noqa: E402
import public  # noqa: E402

SOLUTIONS = Path(__file__).parents[2] / "solutions"

G = 9.81  # m/s^2
PI = 3.141592653589793


class _Captured(Exception):
    """Raised in place of the integration, with its arguments."""


def _loaded(path):
    spec = importlib.util.spec_from_file_location(f"_{path.stem}", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def _capture(rhs, t, y0, *, parameters=None, **_):
    raise _Captured(rhs, tuple(float(y) for y in y0), dict(parameters or {}))


def _handed_over(slug, function, *arguments, **keywords):
    """rhs, y0 and parameters of the first integration that a solution's function asks for."""
    original = tam570.integrate.solve
    tam570.integrate.solve = _capture
    try:
        module = _loaded(SOLUTIONS / f"{slug}.py")  # loaded now, so that it takes `solve` from above
        getattr(module, function)(*arguments, **keywords)
    except _Captured as captured:
        return captured.args
    finally:
        tam570.integrate.solve = original
    raise LookupError(f"{slug}.{function} integrates nothing")


def _times(end):
    import numpy as np

    return np.array([0.0, end])


def _pendulum():
    end = 100 * 10.1  # s, about 200 periods of 2 pi sqrt(l/g) and 100 of an amplitude of 3 rad
    rest = _handed_over("hw01_simple_pendulum", "simulate", _times(end), 3.0, 0.0, length=9.81, gravity=G)
    return *rest, end


def _ballistics():
    keywords = {"mass": 0.5, "drag": 0.1, "gravity": G}
    return *_handed_over("hw02_ballistics", "simulate", _times(20.0), 50.0, 0.8, **keywords), 20.0


def _spring():
    keywords = {"mass": 1.0, "stiffness": 7.0, "gravity": G}
    start = [1.0, 0.2, -0.5], [0.3, -1.0, 0.4]
    return *_handed_over("hw04_hanging_spring", "simulate", _times(100.0), *start, **keywords), 100.0


def _constrained_pendulum():
    keywords = {"mass": 1.0, "length": 1.0, "gravity": G}
    start = [1.0, 0.0, 0.0, 0.0]
    return *_handed_over("hw05_constrained_pendulum", "simulate", _times(100.0), start, **keywords), 100.0


def _braking_car():
    car = {"mass": 1200.0, "yaw_inertia": 1500.0, "front": 1.1, "rear": 1.5, "friction": 0.8, "gravity": G}
    start = [0.0, 0.0, 0.1, 25.0, 0.05]
    return *_handed_over("hw06_braking", "simulate", _times(4.0), start, "rear", **car), 4.0  # stops later


def _double_pendulum():
    keywords = {"masses": (1.0, 1.0), "lengths": (1.0, 1.0), "gravity": G}
    start = [PI / 2, PI / 2], [0.0, 0.0]
    return *_handed_over("hw07_double_pendulum", "simulate", _times(10.0), *start, **keywords), 10.0


def _free_rigid_body():
    start = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.1, 1.0, 0.2]
    keywords = {"inertia": (1.0, 2.0, 3.0)}
    return *_handed_over("hw10_free_rigid_body", "simulate", _times(100.0), *start, **keywords), 100.0


def _bead():
    keywords = {"curvature": 0.5, "gravity": G}
    return *_handed_over("hw12_bead_on_wire", "simulate", _times(100.0), 2.0, 0.0, **keywords), 100.0


def _rolling_cylinder():
    keywords = {"mass": 2.0, "radius": 0.5, "offset": 0.2, "inertia": 0.15, "slope": 0.1, "gravity": G}
    return *_handed_over("hw13_rolling_cylinder", "simulate", _times(20.0), 0.3, 0.0, **keywords), 20.0


def _rolling_disk():
    keywords = {"mass": 1.0, "radius": 0.5, "inertia": (0.0625, 0.125), "gravity": G}
    start = [0.0, 0.0, 0.0, 1.2, 0.0, 0.5, 0.1, 8.0]
    return *_handed_over("hw14_rolling_disk", "simulate_euler", _times(10.0), start, **keywords), 10.0


SCENES = {
    "simple pendulum": _pendulum,
    "ballistics": _ballistics,
    "hanging spring": _spring,
    "constrained pendulum": _constrained_pendulum,
    "braking car": _braking_car,
    "double pendulum": _double_pendulum,
    "free rigid body": _free_rigid_body,
    "bead on wire": _bead,
    "rolling cylinder": _rolling_cylinder,
    "rolling disk": _rolling_disk,
}


SMOOTH = [name for name in lectures.PROBLEMS if name != "rocket"]  # no reference by series past its burnout
OTHERS = {**public.PROBLEMS, **literature.PROBLEMS}
# another set is one more row
SETS = {
    "scenes": list(SCENES),
    "public": list(public.PROBLEMS),
    "literature": list(literature.PROBLEMS),
    "lectures": SMOOTH,
}


def scene(name):
    """(rhs, start, parameters, end): states at `end`, s, are compared."""
    if name in SCENES:
        return SCENES[name]()
    if name in lectures.PROBLEMS:
        return lectures.PROBLEMS[name]
    rhs, start, end = OTHERS[name]
    return rhs, start, {}, end
