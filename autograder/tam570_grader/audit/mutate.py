"""Generate mutants of a reference solution, each with one slip in its syntax tree; read the list of equivalent ones.

Equivalent mutants are no mistakes. autograder/checks/<slug>/equivalent.toml lists them with proofs: a table for each
function, and a line for each slip, as the audit prints it for a survivor:

    [rotate]
    "np.dot(n, r) -> np.dot(r, n)" = "the dot product is symmetric"

If several slips in a function have the same text, the second is "... #2". There are no line numbers, so that a line is
valid as long as the expression exists.
"""

import ast
import collections
import hashlib
import json
import tomllib
from collections.abc import Container, Mapping
from dataclasses import dataclass
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.diagnosis.mutants import changed_expressions, replaced
from tam570_grader.errors import UsageError

Slip = tuple[str, str]  # function, change


@dataclass(frozen=True)
class SolutionMutant:
    """A solution with one slip."""

    slug: str
    function: str
    operator: str
    line: int
    was: str
    now: str
    nth: int  # number among the slips in the function with the same text, from 1
    text: str
    before: str  # the line in the solution
    after: str  # the line in the mutant

    @property
    def change(self) -> str:
        """The change in the function as text, the key in equivalent.toml."""
        return f"{self.was} -> {self.now}" + (f" #{self.nth}" if self.nth > 1 else "")

    @property
    def name(self) -> str:
        """A short name that is unique among all mutants."""
        return f"{self.slug[:4]}.{self.function}.{hashlib.sha256(self.change.encode()).hexdigest()[:8]}"


def mutants(slug: str, source: str) -> list[SolutionMutant]:
    """Return all mutants of a solution's source, in the order of the source."""
    by_text: dict[str, SolutionMutant] = {}
    for function in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        count: collections.Counter[tuple[str, str]] = collections.Counter()
        for node, operator, edit in changed_expressions(function):
            was, now = ast.unparse(node), ast.unparse(edit.now)
            if was == now or (text := replaced(source, node, now)) in by_text:
                continue
            count[was, now] += 1
            lines = (text_of.splitlines()[node.lineno - 1] for text_of in (source, text))
            by_text[text] = SolutionMutant(
                slug, function.name, operator, node.lineno, was, now, count[was, now], text, *lines
            )
    return list(by_text.values())


def equivalents(course: Path, slug: str) -> dict[Slip, str]:
    """Return the proofs of equivalence by slip; raise UsageError if the file is invalid."""
    path = assignments.checks_folder(course, slug) / "equivalent.toml"
    try:
        tables = tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    except ValueError as error:  # not TOML, or not UTF-8
        raise UsageError(f"{path} cannot be read: {error}") from None
    for function, slips in tables.items():
        if not isinstance(slips, dict) or not all(isinstance(proof, str) for proof in slips.values()):
            raise UsageError(f'{path}: {function}: it wants a table [{function}] of lines "slip" = "proof"')
    return {(function, change): proof for function, slips in tables.items() for change, proof in slips.items()}


def entry(mutant: SolutionMutant) -> str:
    """Return the lines that list a mutant in equivalent.toml, without the proof."""
    return f'[{mutant.function}]\n{json.dumps(mutant.change, ensure_ascii=False)} = ""'


def idle(listed: Mapping[Slip, str], mutants: Container[Slip], killed: Container[Slip]) -> dict[Slip, str]:
    """Return the listed slips that must not be listed, each with the reason."""
    faults = {}
    for change, proof in listed.items():
        if change not in mutants:
            faults[change] = "there is no such mutant"
        elif change in killed:
            faults[change] = "it loses points"
        elif not proof.strip():
            faults[change] = "it has no proof"
    return faults
