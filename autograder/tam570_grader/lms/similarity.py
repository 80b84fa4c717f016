"""Find pairs of submissions that share code, by winnowing; names, comments and code from the stub do not count.

The method: S. Schleimer, D. S. Wilkerson, A. Aiken, "Winnowing: local algorithms for document fingerprinting", 2003.
"""

import io
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import combinations
from pathlib import Path
from typing import Any

from tam570_grader.errors import UsageError, counted, progress, say
from tam570_grader.grading.submissions import CannotRead, submissions
from tam570_grader.lms.similarity_export import texts_of
from tam570_grader.sandbox.notebooks import statements_of

SHORTEST = 25  # characters, shortest match of code without names: about two statements
LONGEST = 100_000  # characters of code; the longest solution has 13,000
WINDOW = 5  # one fingerprint is kept of this many consecutive ones


@dataclass(frozen=True)
class Pair:
    """Two students, and the share of each student's code that the other also has."""

    slug: str
    student: str
    other: str
    shares: tuple[float, float]

    @property
    def share(self) -> float:
        """The larger share: lines added to copied code reduce only the other."""
        return max(self.shares)


def run(course: Path, paths: Sequence[Path], slugs: Sequence[str], slug_given: str | None, least: float) -> int:
    """Print the pairs with a share of at least `least`, largest first; return 1 if a submission could not be read."""
    texts, unread = texts_of(submissions(paths, slugs, slug_given), _statements)
    similar = [pair for slug in sorted(texts) for pair in pairs(course, slug, texts[slug]) if pair.share >= least]
    for pair in sorted(similar, key=lambda pair: (-pair.share, pair.slug, pair.student)):
        first, second = (f"{100 * share:3.0f} %" for share in pair.shares)
        say(f"{pair.slug}  {pair.student} {first}  {pair.other} {second}")
    count = sum(map(len, texts.values()))
    shared = f"{counted(len(similar), 'pair')} of {counted(count, 'submission')}"
    say(f"{shared} sharing {100 * least:g} % or more of the code of one of them")
    if unread:
        say(f"not compared, read them yourself: {', '.join(unread)}")
    return 1 if unread else 0


def _statements(text: str) -> str:
    """Return a module's statements in normal form, parsed in the sandbox; CannotRead if they are too long."""
    plain = statements_of(text.encode())
    if len(plain) > LONGEST:
        raise CannotRead(f"it has {len(plain)} characters of code; more than {LONGEST} are not compared")
    return plain


def pairs(course: Path, slug: str, texts: Mapping[str, str]) -> Iterator[Pair]:
    """Yield every pair of an assignment that shares any code."""
    stub = (course / "assignments" / slug / f"{slug}.py").read_text(encoding="utf-8")
    ours = list(_fingerprint(_statements(stub), []).hashes)
    prints = {student: _fingerprint(text, ours) for student, text in sorted(texts.items())}
    everyone = list(combinations(prints, 2))
    from copydetect import compare_files  # type: ignore[import-untyped]  # _fingerprint has raised if it is missing

    for student, other in progress(everyone, len(everyone), "pair"):
        _, (first, second), _ = compare_files(prints[student], prints[other])
        if first or second:
            yield Pair(slug, student, other, (min(1.0, float(first)), min(1.0, float(second))))


def _fingerprint(text: str, ours: Sequence[int]) -> Any:
    """Return the fingerprints of a module without those in `ours`, the stub's."""
    try:
        from copydetect import CodeFingerprint
    except ImportError:
        raise UsageError("alike needs copydetect: pip install 'tam570[grader]'") from None
    return CodeFingerprint("module.py", SHORTEST, WINDOW, boilerplate=ours, language="python", fp=io.StringIO(text))
