"""Wrong solutions by the dozen: one physics-minded slip in the syntax tree of a reference solution each."""

import ast
import collections
import hashlib
from dataclasses import dataclass

from tam570_grader.diagnosis.mutants import changed_expressions, replaced


@dataclass(frozen=True)
class Mutant:
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


def mutants(slug: str, source: str) -> list[Mutant]:
    """Return all mutants of a solution's source, in the order of the source."""
    by_text: dict[str, Mutant] = {}
    for function in (node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)):
        count: collections.Counter[tuple[str, str]] = collections.Counter()
        for node, operator, change in changed_expressions(function):
            was, now = ast.unparse(node), ast.unparse(change)
            if was == now or (text := replaced(source, node, now)) in by_text:
                continue
            count[was, now] += 1
            lines = (text_of.splitlines()[node.lineno - 1] for text_of in (source, text))
            by_text[text] = Mutant(slug, function.name, operator, node.lineno, was, now, count[was, now], text, *lines)
    return list(by_text.values())
