"""Methods: each takes a scene and a tolerance and returns a function without arguments that returns the end state.

What a library does once for a system, such as compiling, is outside the returned function, which is timed.
"""

import functools
import importlib.util
import math

import numpy as np
from run_time.scenes import formulas_of

from tam570.integrate import prepared, solve

LIBRARIES = {
    "tam570, compiled": ["llvmlite"],
    "tam570, prepared": ["llvmlite"],
    "heyoka": ["heyoka"],
    "CyRK": ["CyRK", "numba"],
}


def available(name):
    """Return whether the libraries behind a method are installed."""
    needed = LIBRARIES.get(name, ["numpy" if name.startswith("tam570") else "scipy"])
    return all(importlib.util.find_spec(library) for library in needed)


def ours(method, scene, tolerance):
    rhs, start, parameters, end = scene
    return lambda: solve(rhs, (0.0, end), start, parameters=parameters, rtol=tolerance, method=method)[-1]


def ours_prepared(scene, tolerance):
    """Prepare the run outside the timed function, as for the peers."""
    rhs, start, parameters, end = scene
    run = prepared(rhs, (0.0, end), start, parameters=parameters, rtol=tolerance)
    return lambda: run(start)[-1]


def scipy_ivp(method, scene, tolerance):
    from scipy.integrate import solve_ivp

    rhs, start, parameters, end = scene
    f = functools.partial(rhs, **parameters)
    options = {"method": method, "rtol": max(tolerance, 3e-14), "atol": tolerance}
    return lambda: solve_ivp(f, (0.0, end), start, **options).y[:, -1]


def odeint(scene, tolerance):
    from scipy.integrate import odeint as odepack

    rhs, start, parameters, end = scene
    f = functools.partial(rhs, **parameters)
    options = {"tfirst": True, "rtol": tolerance, "atol": tolerance, "mxstep": 10**7, "full_output": True}

    def states():
        rows, output = odepack(f, start, (0.0, end), **options)
        if output["message"] != "Integration successful.":
            raise RuntimeError(output["message"])  # it returns partial results without raising
        return rows[-1]

    return states


def cyrk(scene, tolerance):
    """Use CyRK's numba interface, with the right-hand side as a callback in C."""
    from CyRK.nb.numba_solver import nbsolve2_ivp

    _, start, _, end = scene
    address = _by_numba(scene).address
    start_array = np.array(start)

    def states():
        solution = nbsolve2_ivp(address, (0.0, end), start_array, method="DOP853", rtol=tolerance, atol=tolerance)
        last = solution.y[:, -1].copy()
        solution.free()
        return last

    return states


def _by_numba(scene):
    """Compile the traced right-hand side with numba, once for each problem, as CyRK's manual advises."""
    formulas, constants = formulas_of(scene)
    lines = [f"c{i} = {c!r}" for i, c in enumerate(constants)] + [f"s{i} = y[{i}]" for i in range(len(scene[1]))]
    lines += [*formulas.lines, *(f"dy[{i}] = {rate}" for i, rate in enumerate(formulas.rates))]
    return _compiled("def rates(dy, t, y, args):\n    " + "\n    ".join(lines))


@functools.cache
def _compiled(source):
    from CyRK.nb.numba_solver import cyjit

    names = dict(vars(math))
    exec(compile(source, "<rates>", "exec"), names)
    return cyjit(names["rates"])


def _by_heyoka(scene):
    """Return pairs of variables and rates, as heyoka's integrators take them."""
    import heyoka as hy

    state = [hy.make_vars(f"s{i}") for i in range(len(scene[1]))]
    formulas, constants = formulas_of(scene)
    names = {name: getattr(hy, name) for name in ("sin", "cos", "sqrt", "exp")}
    names |= {"t": hy.time, "hypot": lambda a, b: hy.sqrt(a * a + b * b)}
    names |= {f"s{i}": s for i, s in enumerate(state)} | {f"c{i}": c for i, c in enumerate(constants)}
    exec("\n".join(formulas.lines), names)
    rates = [eval(rate, names) for rate in formulas.rates]
    rates = [rate if isinstance(rate, hy.expression) else hy.expression(rate) for rate in rates]
    return list(zip(state, rates, strict=True))


def heyoka(scene, tolerance):
    import heyoka as hy

    _, start, _, end = scene
    compact = len(start) > 20  # as its manual advises for large systems
    run = hy.taylor_adaptive(_by_heyoka(scene), list(start), tol=tolerance, compact_mode=compact)

    def states():
        run.time, run.state[:] = 0.0, start
        run.step(end / 1000)  # bounded: at rest heyoka may choose a step of any length
        run.propagate_until(end)
        return run.state.copy()

    return states


def ours_from(scene, starts, tolerance):
    """Return a function that returns the ends of all motions from these (m, n) starts."""
    rhs, _, parameters, end = scene
    return lambda: solve(rhs, (0.0, end), starts, parameters=parameters, rtol=tolerance, method="compiled")[:, -1]


def heyoka_from(scene, starts, tolerance):
    """Return the same for heyoka's batches of eight; m must be a multiple of eight."""
    import heyoka as hy

    end, size, lanes = scene[-1], starts.shape[1], 8
    run = hy.taylor_adaptive_batch(_by_heyoka(scene), np.zeros((size, lanes)), tol=tolerance)

    def ends():
        last = np.empty_like(starts)
        for first in range(0, len(starts), lanes):
            run.set_time(0.0)
            run.state[:] = starts[first : first + lanes].T
            run.propagate_until(end)
            last[first : first + lanes] = run.state.T
        return last

    return ends


METHODS = {
    "tam570, Python": functools.partial(ours, "python"),
    "tam570, compiled": functools.partial(ours, "compiled"),
    "tam570, prepared": ours_prepared,
    "tam570, auto": functools.partial(ours, "auto"),
    "tam570, Gauss": functools.partial(ours, "gauss"),
    "tam570, composition": functools.partial(ours, "composition"),
    "SciPy RK45": functools.partial(scipy_ivp, "RK45"),
    "SciPy DOP853": functools.partial(scipy_ivp, "DOP853"),
    "SciPy LSODA": functools.partial(scipy_ivp, "LSODA"),
    "SciPy Radau": functools.partial(scipy_ivp, "Radau"),
    "odeint": odeint,
    "CyRK": cyrk,
    "heyoka": heyoka,
}
