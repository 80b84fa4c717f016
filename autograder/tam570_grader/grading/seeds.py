"""Seeds of the hidden inputs: one for the whole class, or derived from a key for each student."""

import functools
import hmac
import os
import secrets
from collections.abc import Sequence
from pathlib import Path

import numpy as np

from tam570_grader.checks.check import Check
from tam570_grader.errors import UsageError, warn, writing
from tam570_grader.results.store import Results

BITS = 128  # per seed: too many to find a seed by trial from the inputs that feedback pages show
SHORTEST_KEY = 16  # bytes
OTHERS = 0o077  # permission bits of the group and of others


def seed(chosen: int | None, earlier: Sequence[Results], key: bytes | None) -> int:
    """Return the chosen seed, else that of the earlier results, else a new one; 0 if only a key is given."""
    if key is not None or chosen is not None:
        return chosen or 0
    distinct = {line.seed for results in earlier for line in results.lines.values()}
    if len(distinct) > 1:
        raise UsageError(
            "these results have more than one seed: give the key that they were varied by (--vary), or a --seed"
        )
    return distinct.pop() if distinct else new_seed()


def new_seed() -> int:
    """Return a random seed that nobody can guess."""
    return secrets.randbits(BITS)


def derive(secret: int | bytes, *names: str) -> int:
    """Return the HMAC-SHA256 (RFC 2104) of the names, cut to BITS: it reveals neither the secret nor other seeds."""
    if isinstance(secret, int):
        secret = secret.to_bytes(max(BITS, secret.bit_length()) // 8 + 1)
    return int.from_bytes(hmac.digest(secret, "\n".join(names).encode(), "sha256")[: BITS // 8])


def generator(seed: int, slug: str, check: Check) -> np.random.Generator:
    """Return the random generator of a check's hidden inputs."""
    return np.random.Generator(np.random.PCG64(_sequence(seed, slug, check.name)))


@functools.lru_cache(maxsize=1024)
def _sequence(seed: int, slug: str, name: str) -> np.random.SeedSequence:
    """Return the seed sequence of a check's generator; cached because it takes longer to make than the generator."""
    return np.random.SeedSequence(derive(seed, slug, name))


def key(path: Path, needed: bool) -> bytes:
    """Return the key in a file; if there is none, write a new key, or raise UsageError if earlier results needed it."""
    if not path.exists():
        if needed:
            raise UsageError(
                f"there is no key in {path}, and there are earlier results. Name the key that they were varied by. "
                "If they were graded with a seed, leave --vary away or name a new folder with --out."
            )
        with writing(path):
            new_file = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
        with open(new_file, "w", encoding="ascii") as file:
            file.write(secrets.token_hex(32) + "\n")
        warn(f"a new key: {path}; keep it, the scores hang on it", "")
    try:
        key = path.read_bytes().strip()
        if path.stat().st_mode & OTHERS:
            warn(f"the key is not yours alone: chmod 600 {path}")
    except OSError as error:
        raise UsageError(f"cannot read the key {path}: {error.strerror}") from None
    if len(key) < SHORTEST_KEY:
        raise UsageError(
            f"{path} is not a key: it holds fewer than {SHORTEST_KEY} bytes; name a new file to have one made"
        )
    return key
