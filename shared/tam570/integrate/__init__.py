"""Solve the initial value problems of mechanics: states at the times asked for, nothing else."""

from tam570.integrate.solver import solve

__all__ = ["solve"]
