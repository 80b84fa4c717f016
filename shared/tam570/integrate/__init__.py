"""Solve the initial value problems of mechanics: states at given times.

`solve(rhs, t, y0, parameters=..., rtol=1e-10)` is enough for most scenes. Further options::

    method="gauss", "composition"  conservative systems over long times, at a fixed step
    project=function               a holonomic constraint, restored after every step
    solve_rotation(...)            rotations that stay orthogonal, by Lie-group steps
    prepared(rhs, t, y0, ...)      a function of the start, for many short runs
    y0 of shape (m, k)             m starts at once
    events=, dense=, report=       zeros of functions, dense output, statistics of the run
"""

from tam570.integrate.rotation import solve_rotation
from tam570.integrate.solver import prepared, solve

__all__ = ["prepared", "solve", "solve_rotation"]
