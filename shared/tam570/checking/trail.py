"""A file in which a process records its current step, for its parent: a student's code may end the process."""

import json
from pathlib import Path

SIZE = 1000  # bytes: each step overwrites the last


class Trail:
    """The current step of the process, overwritten in a file; without a file nothing is recorded."""

    def __init__(self, file: str = "") -> None:
        self._file = open(file, "wb", buffering=0) if file else None  # noqa: SIM115  open until the end
        self._step = {"slug": "", "test": "", "function": ""}

    def enter(self, **step: str) -> None:
        """Record which assignment, test or function is next."""
        self._step |= step
        if self._file:
            self._file.seek(0)
            self._file.write(json.dumps(self._step).encode()[:SIZE].ljust(SIZE))


def last_step(file: Path) -> dict[str, str]:
    """Return the last step that a process recorded; all values are "" if there is none."""
    try:
        step: dict[str, str] = json.loads(file.read_bytes())
    except (OSError, ValueError):
        return {"slug": "", "test": "", "function": ""}
    return step
