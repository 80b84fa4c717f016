"""Solve the initial value problems of mechanics: states at the times asked for, nothing else.

`solve(rhs, t, y0, parameters=..., rtol=1e-10)` is all that most scenes need. For the rest::

    method="gauss", "composition"  conservative systems over long times, at a fixed step
    project=function               a holonomic constraint, restored after every step
    solve_rotation(...)            rotations that stay rotations, by Lie-group steps
    prepared(rhs, t, y0, ...)      a function of the start alone, for many short runs in turn
    y0 of shape (m, k)             m starts at once
    events=, dense=, report=       zeros of functions, the motion as a function of time, how the run went
"""

from tam570.integrate.rotation import solve_rotation
from tam570.integrate.solver import prepared, solve

__all__ = ["prepared", "solve", "solve_rotation"]
