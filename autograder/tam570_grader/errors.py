"""What the commands tell an instructor without a traceback."""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

__all__ = ["UsageError", "writing"]


class UsageError(Exception):
    """Something that was asked for cannot be done; the message names the input and the remedy."""


@contextmanager
def writing(place: Path) -> Iterator[None]:
    """What cannot be written to a place that was asked for is bad usage."""
    try:
        yield
    except OSError as error:
        raise UsageError(
            f"cannot write to {place}: {error.strerror or error}; name another place, or make its folder first"
        ) from None
