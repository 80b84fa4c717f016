"""Lagrange's equations of the second kind, with multipliers for constraints."""

from collections.abc import Sequence
from dataclasses import dataclass

import sympy

from tam570.lagrange import Expression, Symbol


@dataclass(frozen=True)
class EquationsOfMotion:
    """M a = F + A^T lam and A a + bias = 0, for accelerations a and multipliers lam."""

    time: Symbol
    coordinates: tuple[Symbol, ...]
    velocities: tuple[Symbol, ...]
    parameters: tuple[Symbol, ...]
    mass: tuple[tuple[Expression, ...], ...]  # M
    forcing: tuple[Expression, ...]  # F
    matrix: tuple[tuple[Expression, ...], ...]  # A
    bias: tuple[Expression, ...]
    errors: tuple[Expression, ...]  # of the holonomic constraints, then of the rates of all
    energy: Expression


def motion(
    lagrangian: Expression,
    coordinates: Sequence[Symbol],
    velocities: Sequence[Symbol],
    constraints: Sequence[Expression],
    forces: Sequence[Expression],
    time: Symbol | None,
) -> EquationsOfMotion:
    """Derive d/dt dL/dv - dL/dq = Q + A^T lam, with the derivative along the motion written out."""
    q, v, t = tuple(coordinates), tuple(velocities), sympy.Symbol("t") if time is None else time
    if not q or len(q) != len(v):
        raise ValueError(f"velocities: one for each coordinate, got {len(v)} for {len(q)}")
    if forces and len(forces) != len(q):
        raise ValueError(f"forces: one for each coordinate, got {len(forces)} for {len(q)}")
    L = sympy.sympify(lagrangian)
    Q = tuple(sympy.sympify(force) for force in forces) or (sympy.Integer(0),) * len(q)
    all_constraints = tuple(sympy.sympify(constraint) for constraint in constraints)
    holonomic = tuple(c for c in all_constraints if not c.has(*v))
    rates = tuple(c if c.has(*v) else _carried(c, q, v, t) for c in all_constraints)
    matrix = sympy.Matrix(len(rates), len(v), [sympy.diff(rate, w) for rate in rates for w in v])
    if matrix.has(*v):
        raise ValueError("constraints must be linear in the velocities")
    momenta = [sympy.diff(L, w) for w in v]
    mass = sympy.Matrix([[sympy.simplify(sympy.diff(p, w)) for w in v] for p in momenta])
    if _rank(mass) < mass.rows:
        raise ValueError("lagrangian: the mass matrix is singular; a coordinate has no inertia of its own")
    if _rank(matrix) < matrix.rows:
        raise ValueError("constraints are not independent: leave out what follows from the others")
    _check_pivots(mass, matrix)
    used = set().union(*(e.free_symbols for e in (L, *Q, *all_constraints)))
    return EquationsOfMotion(
        time=t,
        coordinates=q,
        velocities=v,
        parameters=tuple(sorted(used - {t, *q, *v}, key=str)),
        mass=tuple(map(tuple, mass.tolist())),
        forcing=tuple(sympy.diff(L, x) - _carried(p, q, v, t) + f for x, p, f in zip(q, momenta, Q, strict=True)),
        matrix=tuple(map(tuple, matrix.tolist())),
        bias=tuple(_carried(rate, q, v, t) for rate in rates),
        errors=holonomic + rates,
        energy=sum((p * w for p, w in zip(momenta, v, strict=True)), -L),
    )


def _carried(expression: Expression, q: Sequence[Symbol], v: Sequence[Symbol], t: Symbol) -> Expression:
    """Return the rate of an expression along the motion at constant velocities."""
    return sum((sympy.diff(expression, x) * w for x, w in zip(q, v, strict=True)), sympy.diff(expression, t))


def _check_pivots(mass: Expression, matrix: Expression) -> None:
    """Raise ValueError for an indefinite M with which elimination, without exchange of rows, divides by zero."""
    M, A = _at_numbers(mass, matrix)
    for system in (M, A * M.inv() * A.T):
        if any(_rank(system[:k, :k]) < k for k in range(1, system.rows + 1)):
            raise ValueError(
                f"lagrangian: the mass matrix {mass.tolist()} is indefinite, and elimination divides by zero; choose "
                "other coordinates, such as sums and differences of these"
            )


def _at_numbers(*matrices: Expression) -> list[Expression]:
    """Evaluate the matrices with some numbers for their symbols, in 30 digits."""
    symbols = sorted(set().union(*(matrix.free_symbols for matrix in matrices)), key=str)
    numbers = {symbol: sympy.Rational(17 + i, 13) for i, symbol in enumerate(symbols)}
    return [matrix.subs(numbers).evalf(30) for matrix in matrices]


def _rank(matrix: Expression) -> int:
    """Return the rank of a matrix with some numbers for its symbols."""
    (at_numbers,) = _at_numbers(matrix)
    negligible = 1e-20 * at_numbers.norm()  # far above the rounding of 30 digits
    return int(at_numbers.rank(iszerofunc=lambda x: abs(x) <= negligible))
