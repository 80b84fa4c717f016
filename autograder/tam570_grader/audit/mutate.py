"""Wrong solutions by the dozen, one slip in the syntax tree of a reference solution each; some are no mistakes.

These are listed, each with its proof, in autograder/checks/<slug>/equivalent.toml: a table for each function, a
line for each slip in it, as the audit prints it of a survivor:

    [rotate]
    "np.dot(n, r) -> np.dot(r, n)" = "the dot product is symmetric"

Of slips that read alike in a function the second is "... #2". No line numbers: a line is good as long as the
expression is there.
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

Slip = tuple[str, str]  # function, what was done in it


@dataclass(frozen=True)
class SolutionMutant:
    """A solution with one slip."""

    slug: str
    function: str
    operator: str
    line: int
    was: str
    now: str
    nth: int  # of the slips in the function that read alike, from 1
    text: str
    before: str  # the line
    after: str

    @property
    def change(self) -> str:
        """What was done in the function; it reads the same as long as the expression does."""
        return f"{self.was} -> {self.now}" + (f" #{self.nth}" if self.nth > 1 else "")

    @property
    def name(self) -> str:
        """A short name among all mutants."""
        return f"{self.slug[:4]}.{self.function}.{hashlib.sha256(self.change.encode()).hexdigest()[:8]}"


def mutants(slug: str, source: str) -> list[SolutionMutant]:
    """Return all mutants of a solution's source, in the order of the source."""
    by_text: dict[str, SolutionMutant] = {}
    for function in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        count: collections.Counter[tuple[str, str]] = collections.Counter()
        for node, operator, change in changed_expressions(function):
            was, now = ast.unparse(node), ast.unparse(change)
            if was == now or (text := replaced(source, node, now)) in by_text:
                continue
            count[was, now] += 1
            lines = (text_of.splitlines()[node.lineno - 1] for text_of in (source, text))
            by_text[text] = SolutionMutant(
                slug, function.name, operator, node.lineno, was, now, count[was, now], text, *lines
            )
    return list(by_text.values())


def equivalents(course: Path, slug: str) -> dict[Slip, str]:
    """Return the proofs by slip; UsageError if the file holds anything else."""
    path = assignments.checks_folder(course, slug) / "equivalent.toml"
    try:
        tables = tomllib.loads(path.read_text(encoding="utf-8")) if path.exists() else {}
    except ValueError as error:  # no TOML, no UTF-8
        raise UsageError(f"{path} cannot be read: {error}") from None
    for function, slips in tables.items():
        if not isinstance(slips, dict) or not all(isinstance(proof, str) for proof in slips.values()):
            raise UsageError(f'{path}: {function}: it wants a table [{function}] of lines "slip" = "proof"')
    return {(function, change): proof for function, slips in tables.items() for change, proof in slips.items()}


def entry(mutant: SolutionMutant) -> str:
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
