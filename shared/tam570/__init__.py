"""Common utilities of the course: rotations, integration, invariants."""

__version__ = "0.1.0"
