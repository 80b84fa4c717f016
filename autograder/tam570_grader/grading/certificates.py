"""A cluster's certificate and key: who holds the key may join it, and nobody else."""

from pathlib import Path

from tam570_grader.errors import UsageError

NAMES = ("certificate.pem", "key.pem")


def files(folder: Path) -> tuple[str, str]:
    """Return the certificate and the key in a folder; UsageError if they are not there."""
    paths = [folder / name for name in NAMES]
    if lacking := [path for path in paths if not path.is_file()]:
        raise UsageError(f"{lacking[0]} is not there; make it with: tam570-grader certificates {folder}")
    return str(paths[0]), str(paths[1])
