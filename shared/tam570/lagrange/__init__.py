"""Turn a Lagrangian in SymPy into functions of plain floats.

For example::

    x, v, m, c, g = sympy.symbols("x v m c g")
    text = lagrange.source(m * v**2 * (1 + 4 * c**2 * x**2) / 2 - m * g * c * x**2, [x], [v])
    bead = lagrange.load(text)
    integrate.solve(bead.rhs, t, [0.5, 0.0], parameters={"m": 1.0, "c": 2.0, "g": 9.81})

`source` needs SymPy and is called once. Its text is plain Python that imports only `math`: load it, or save it as a
file and import that. It has these functions, all with the arguments `(t, state, *, parameters)`:

- rhs                 : the rates (velocities, accelerations) of the state (coordinates, velocities)
- mass_matrix, forcing: M and F of  M a = F + A^T lam, as tuples
- energy              : Jacobi's integral, sum of v dL/dv less L: T + V in axes that do not move
- with constraints    : constraint_matrix A, multipliers lam, and constraint_errors, which stay zero;
                        A^T lam are the generalised constraint forces
"""

import hashlib
import linecache
from collections.abc import Sequence
from types import ModuleType
from typing import Any

__all__ = ["load", "source"]

Expression = Any  # what sympy.sympify takes
Symbol = Any  # sympy.Symbol


def source(
    lagrangian: Expression,
    coordinates: Sequence[Symbol],
    velocities: Sequence[Symbol],
    *,
    constraints: Sequence[Expression] = (),
    forces: Sequence[Expression] = (),
    time: Symbol = None,
) -> str:
    """Write the equations of motion of a Lagrangian as Python text.

    Parameters
    ----------
    lagrangian : expression
        In the coordinates, velocities, time and parameters, all plain symbols. The other symbols are the parameters,
        and become keyword arguments.
    coordinates, velocities : sequences of n symbols
        In the same order.
    constraints : sequence of expressions
        Expressions that are zero: in coordinates and time (holonomic), or linear in the velocities.
    forces : sequence of n expressions
        Generalised forces that the Lagrangian does not contain; empty for none.
    time : symbol
        "t" if not given.

    Returns
    -------
    str
        Pass it to `load`, or save it as a file.

    Raises
    ------
    ValueError
        If a name cannot be a parameter's, if a coordinate has no inertia of its own, or if the constraints are not
        linear in the velocities or not independent.

    Examples
    --------
    >>> import sympy
    >>> s, v, k, m = sympy.symbols("s v k m")
    >>> spring = load(source(m * v**2 / 2 - k * s**2 / 2, [s], [v]))
    >>> spring.rhs(0.0, (1.0, 0.0), k=4.0, m=1.0)
    (0.0, -4.0)
    """
    from tam570.lagrange import _derivation, _writing  # SymPy is slow to import

    motion = _derivation.motion(lagrangian, coordinates, velocities, constraints, forces, time)
    return _writing.module(motion)


def load(text: str) -> ModuleType:
    """Load the text of `source` as a module; tracebacks and `inspect` show its lines.

    Parameters
    ----------
    text : str

    Returns
    -------
    module
        With `rhs`, `mass_matrix`, `forcing` and `energy`; with constraints also `constraint_matrix`, `multipliers` and
        `constraint_errors`.

    Examples
    --------
    >>> import sympy
    >>> x, u = sympy.symbols("x u")
    >>> load(source(u**2 / 2, [x], [u])).energy(0.0, (0.0, 3.0))
    4.5
    """
    name = f"equations_{hashlib.sha256(text.encode()).hexdigest()[:12]}"
    file = f"<{name}>"
    linecache.cache[file] = (len(text), None, text.splitlines(keepends=True), file)
    module = ModuleType(name, text.splitlines()[0])
    exec(compile(text, file, "exec"), module.__dict__)
    return module
