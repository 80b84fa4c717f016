"""Reference states to 30 digits: Gragg's midpoint rule in mpmath, extrapolated, on the traced right-hand side.

Hairer, Norsett and Wanner, Solving Ordinary Differential Equations I, section II.9.
"""

import mpmath
from run_time.scenes import formulas_of

DIGITS, COLUMNS = 50, 16  # extrapolation amplifies rounding
TOLERANCE = mpmath.mpf(10) ** -34  # of a step, relative to the state
FUNCTIONS = {name: getattr(mpmath, name) for name in ("sin", "cos", "exp", "sqrt", "hypot")}


def end_state(scene):
    """Return (k,) mpf, the state at the end of the scene; the scene's floats are taken as exact."""
    _, start, _, end = scene
    formulas, constants = formulas_of(scene)
    code = compile("\n".join([*formulas.lines, f"rates = [{', '.join(formulas.rates)}]"]), "<rates>", "exec")
    with mpmath.workdps(DIGITS):
        names = {**FUNCTIONS, **{f"c{i}": mpmath.mpf(c) for i, c in enumerate(constants)}}

        def rates(t, state):
            names.update({"t": t, **{f"s{i}": x for i, x in enumerate(state)}})
            exec(code, names)
            return names["rates"]

        state, t, end = [mpmath.mpf(x) for x in start], mpmath.mpf(0), mpmath.mpf(end)
        h = end / 1000
        while t < end:
            h = min(h, end - t)
            after, error = _step(rates, t, state, h)
            if error <= TOLERANCE:
                state, t = after, t + h
            h *= min(2, 0.9 * (TOLERANCE / (error + mpmath.eps)) ** (mpmath.mpf(1) / (2 * COLUMNS - 1)))
        return state


def _step(rates, t, state, h):
    """Return the state after a step, and the last change by extrapolation relative to it."""
    slopes, row = rates(t, state), []
    for j in range(1, COLUMNS + 1):
        small = h / (2 * j)
        before, now = state, _moved(state, small, slopes)
        for i in range(1, 2 * j):
            before, now = now, _moved(before, 2 * small, rates(t + i * small, now))
        finer = [now]
        for k, coarser in enumerate(row, 1):
            change = [a - b for a, b in zip(finer[-1], coarser, strict=True)]
            finer.append(_moved(finer[-1], 1 / ((mpmath.mpf(j) / (j - k)) ** 2 - 1), change))
        row = finer
    return row[-1], max(map(abs, change)) / max(map(abs, row[-1]))


def _moved(state, step, slopes):
    return [x + step * slope for x, slope in zip(state, slopes, strict=True)]
