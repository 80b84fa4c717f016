"""Mutants that are no mistakes, each listed with its proof: autograder/checks/<slug>/equivalent.toml.

A table for each function, a line for each slip in it, as the audit prints it of a survivor:

    [rotate]
    "np.dot(n, r) -> np.dot(r, n)" = "the dot product is symmetric"

Of slips that read alike in a function the second is "... #2". No line numbers: a line is good as long as the
expression is there.
"""

import json
import tomllib
from collections.abc import Container, Mapping
from pathlib import Path

from tam570_grader.audit.mutate import Mutant
from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError

Slip = tuple[str, str]  # function, what was done in it


def equivalents(course: Path, slug: str) -> dict[Slip, str]:
    """Return the proofs by slip."""
    path = assignments.checks_folder(course, slug) / "equivalent.toml"
    tables = _tables(path) if path.exists() else {}
    return {(function, change): proof for function, slips in tables.items() for change, proof in slips.items()}


def _tables(path: Path) -> dict[str, dict[str, str]]:
    """Return the slips and proofs by function; UsageError if the file holds anything else."""
    try:
        tables = tomllib.loads(path.read_text(encoding="utf-8"))
    except ValueError as error:  # no TOML, no UTF-8
        raise UsageError(f"{path} cannot be read: {error}") from None
    for function, slips in tables.items():
        if not isinstance(slips, dict) or not all(isinstance(proof, str) for proof in slips.values()):
            raise UsageError(f'{path}: {function}: it wants a table [{function}] of lines "slip" = "proof"')
    return tables


def entry(mutant: Mutant) -> str:
    """Return the line that lists a mutant, but for the proof."""
    return f'[{mutant.function}]\n{json.dumps(mutant.change, ensure_ascii=False)} = ""'


def idle(listed: Mapping[Slip, str], mutants: Container[Slip], killed: Container[Slip]) -> dict[Slip, str]:
    """Return what is wrong with lines that list in vain."""
    faults = {}
    for change, proof in listed.items():
        if change not in mutants:
            faults[change] = "there is no such mutant"
        elif change in killed:
            faults[change] = "it loses points"
        elif not proof.strip():
            faults[change] = "it has no proof"
    return faults
