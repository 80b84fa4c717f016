"""What the commands tell an instructor without a traceback."""

__all__ = ["UsageError"]


class UsageError(Exception):
    """Something that was asked for cannot be done; the message names the input and the remedy."""
