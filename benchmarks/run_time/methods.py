"""Each method as a function from a scene and a tolerance to a function without arguments that gives the end state.

What a library does once for a system (compiling it) is done outside the function that is timed.
"""

import functools
import importlib.util

from tam570.integrate import solve


def available(name):
    """Whether the library behind a method is installed."""
    library = {"tam570, compiled": "llvmlite", "tam570, auto": "llvmlite"}
    peers = {"heyoka": "heyoka", "CyRK": "CyRK", "diffrax": "diffrax"}
    needed = {**library, **peers}.get(name, "numpy" if name.startswith("tam570") else "scipy")
    return importlib.util.find_spec(needed) is not None


def ours(method, scene, tolerance):
    rhs, start, parameters, end = scene
    return lambda: solve(rhs, (0.0, end), start, parameters=parameters, rtol=tolerance, method=method)[-1]


def scipy_ivp(method, scene, tolerance):
    from scipy.integrate import solve_ivp

    rhs, start, parameters, end = scene
    f = functools.partial(rhs, **parameters)
    given = {"method": method, "rtol": max(tolerance, 3e-14), "atol": tolerance}
    return lambda: solve_ivp(f, (0.0, end), start, **given).y[:, -1]


def odeint(scene, tolerance):
    from scipy.integrate import odeint as odepack

    rhs, start, parameters, end = scene
    f = functools.partial(rhs, **parameters)
    given = {"tfirst": True, "rtol": tolerance, "atol": tolerance, "mxstep": 10**7, "full_output": True}

    def states():
        found, told = odepack(f, start, (0.0, end), **given)
        if told["message"] != "Integration successful.":
            raise RuntimeError(told["message"])  # it returns what it has, and no error
        return found[-1]

    return states


def cyrk(scene, tolerance):
    import numpy as np
    from CyRK import pysolve_ivp

    rhs, start, parameters, end = scene
    f = functools.partial(rhs, **parameters)

    def rates(dy, t, y):
        dy[:] = f(t, y)

    given = {"method": "DOP853", "rtol": tolerance, "atol": tolerance, "pass_dy_as_arg": True}
    return lambda: pysolve_ivp(rates, (0.0, end), np.array(start), **given).y[:, -1]


def heyoka(scene, tolerance):
    import heyoka as hy

    rhs, start, parameters, end = scene
    names = [f"s{i}" for i in range(len(start))]
    state = [hy.make_vars(name) for name in names]
    rates = _rates_in(rhs, parameters, len(start), hy, hy.time)(state)
    rates = [rate if isinstance(rate, hy.expression) else hy.expression(rate) for rate in rates]
    run = hy.taylor_adaptive(list(zip(state, rates, strict=True)), list(start), tol=tolerance)

    def states():
        run.time, run.state[:] = 0.0, start
        run.step(end / 1000)  # bounded: at rest its own choice may be any length
        run.propagate_until(end)
        return run.state.copy()

    return states


@functools.cache
def _diffrax_kernel():
    import diffrax
    import jax

    jax.config.update("jax_enable_x64", True)

    @functools.partial(jax.jit, static_argnums=0)
    def kernel(field, start, end, tolerance):
        control = diffrax.PIDController(rtol=tolerance, atol=tolerance)
        term, method = diffrax.ODETerm(field), diffrax.Dopri8()
        return diffrax.diffeqsolve(
            term, method, 0.0, end, None, start, stepsize_controller=control, max_steps=10**7, throw=False
        ).ys

    return kernel


_FIELDS = {}  # jax compiles once for each function object


def diffrax(scene, tolerance):
    kernel = _diffrax_kernel()
    import jax.numpy as jnp

    rhs, start, parameters, end = scene
    key = (rhs.__code__, str(parameters))
    if key not in _FIELDS:
        rates = _rates_in(rhs, parameters, len(start), jnp, None)
        _FIELDS[key] = lambda t, y, _: jnp.stack([jnp.asarray(r, dtype=float) for r in rates(y)])
    field = _FIELDS[key]
    return lambda: kernel(field, jnp.array(start), end, tolerance)[0].block_until_ready()


def _rates_in(rhs, parameters, size, library, time):
    """The traced right-hand side with the functions of another library."""
    from tam570.integrate.formulas import written
    from tam570.integrate.trace import traced

    formulas, constants = written(traced(functools.partial(rhs, **parameters), size))
    lines = [f"c{i} = {c!r}" for i, c in enumerate(constants)] + list(formulas.lines)
    code = compile("\n".join([*lines, f"rates = [{', '.join(formulas.rates)}]"]), "<rates>", "exec")

    def rates(state):
        names = {name: getattr(library, name) for name in dir(library) if name in ("sin", "cos", "sqrt", "exp")}
        names |= {"hypot": lambda a, b: library.sqrt(a * a + b * b)}
        names |= {"t": time, **{f"s{i}": state[i] for i in range(size)}}
        exec(code, names)
        return names["rates"]

    return rates


METHODS = {
    "tam570, Python": functools.partial(ours, "python"),
    "tam570, compiled": functools.partial(ours, "compiled"),
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
    "diffrax": diffrax,
}
