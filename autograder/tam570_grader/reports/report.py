"""The instructor's report on a class: one HTML file whose tables can be sorted, filtered and paged."""

import base64
import contextlib
import hashlib
import heapq
import statistics
from collections import defaultdict
from collections.abc import Callable, Collection, Container, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Any

from tam570.values import Json
from tam570_grader.checks.failure import Failure
from tam570_grader.checks.rubric import load_rubric
from tam570_grader.errors import UsageError, say, writing
from tam570_grader.reports.feedback import STOPPED, AssignmentInfo, load_assignment_info, template
from tam570_grader.reports.scenes import wrong_and_right
from tam570_grader.reports.sentences import points
from tam570_grader.results import manual_points, shared, store
from tam570_grader.results.manual_points import EX, EXCUSED, GradeRow
from tam570_grader.results.records import CheckResult, Result
from tam570_grader.results.store import Key
from tam570_grader.results.tables import written

SLOWEST = 20  # number of slowest submissions listed
SCENES = 3  # number of commonest mistakes with pictures
BINS = 10  # bins of the distribution of scores
OUTCOMES = ("passed", "failed", "not_run", "grader_error")
FAILED = "Not passed:"  # prefix of a failed check that no known mistake explains
SCRIPT = Path(__file__).parent / "templates" / "report.js"
Everyone = Callable[[Collection[str]], Iterable[str]]
Class = Mapping[Key, Result]  # the newest result of each student and assignment, sorted
Examples = dict[tuple[str, str], Failure]  # by assignment and `_what_went_wrong`
Signs = dict[Key, list[shared.Sign]]


def run(
    folder: Path,
    course: Path,
    everyone: Everyone | None,
    out: Path | None,
    names: Mapping[str, str],
    hand_ins: Sequence[Json],
) -> int:
    """Write the report on the results in a folder; return the exit code.

    everyone : function from the students with results to all students of the course
    names    : names of the students by their ids in the results
    hand_ins : a row for each assignment: how often and when students handed in
    """
    signs, examples = Signs(), Examples()
    class_results = results(folder, signs, examples)
    page = out or folder / "report.html"
    roster = everyone({student for student, _ in class_results}) if everyone else ()
    slugs, adjustments = _slugs(class_results), manual_points.read(folder)
    infos = {slug: load_assignment_info(course, slug) for slug in slugs}
    scenes = []  # the commonest mistakes, each with a pair of pictures or None
    for it in _suspects(class_results.values(), infos)[:SCENES]:
        failure = examples.get((it["slug"], it["key"]))
        scenes.append({**it, "pair": wrong_and_right(course, it["slug"], it["key"], failure)})
    text = report(
        class_results,
        infos,
        roster,
        dropped=adjustments.dropped(
            GradeRow(*key, result.status, result.score, result.max_score) for key, result in class_results.items()
        ),
        shared=shared.groups(signs),
        names=names,
        claims=_claims(adjustments, course, slugs),
        scenes=scenes,
        hand_ins=hand_ins,
    )
    with writing(page):
        written(page, text)
    say(str(page))
    return 0


def results(folder: Path, signs: Signs | None = None, examples: Examples | None = None) -> Class:
    """Return the newest results in a folder, with adjustments by hand; see `newest` for `signs` and `examples`."""
    with contextlib.closing(store.results(folder)) as lines:
        class_results = newest(map(lines.result, lines), signs, examples)
    if not class_results:
        raise UsageError(f"{folder / 'results.jsonl'} is empty; nothing has been graded yet")
    adjustments = manual_points.read(folder)
    return {key: adjustments.applied(result) for key, result in class_results.items()}


def newest(results: Iterable[Result], signs: Signs | None = None, examples: Examples | None = None) -> Class:
    """Return the newest results without data that the page does not show; equal check results share one object.

    signs    : filled with the signs of shared wrong results, by student and assignment
    examples : filled with the first failure of each kind
    """
    equal = dict[CheckResult, CheckResult]()
    class_results = dict[Key, Result]()
    for result in results:
        checks = []
        for check in result.checks:
            failure = check.failure
            hint = failure.hint if failure else ""
            source = f"It follows from {failure.follows_from}." if failure and failure.follows_from else ""
            bare = replace(check, message=source or hint, failure=None)
            checks.append(equal.setdefault(bare, bare))
            if failure and examples is not None:
                examples.setdefault((result.assignment, _what_went_wrong(bare)), failure)
        key = result.student, result.assignment
        if signs is not None:
            signs[key] = [*shared.signs_of(result)]
        class_results[key] = replace(result, checks=tuple(checks), speed=None, digest="")
    return dict(sorted(class_results.items()))


def report(
    class_results: Class, infos: Mapping[str, AssignmentInfo], roster: Iterable[str] = (), **sections: Any
) -> str:
    """Return the page, a self-contained HTML file with links to the feedback pages beside it.

    sections : dropped, shared, names, claims, scenes, hand_ins; the page omits those that are missing
    """
    script = SCRIPT.read_text(encoding="utf-8")
    students = sorted({student for student, _ in class_results} | set(roster))
    everything, here = class_results.values(), {key for key, result in class_results.items() if _here(result)}
    return template("report.html").render(
        {"shared": (), "names": {}, "claims": (), "scenes": (), "hand_ins": ()} | sections,
        slugs=_slugs(class_results),
        infos=infos,
        students=len(students),
        handed_in=len(here),
        seeds=sorted({result.seed for result in everything}),
        isolation=sorted({result.isolation for result in everything}),
        assignments=[*_assignments(class_results, infos)],
        scores=_scores(class_results, students, sections.get("dropped", ())),
        tallies=_tallies(everything, infos),
        suspects=_suspects(everything, infos),
        stopped=[result for result in everything if result.status in STOPPED],
        slowest=heapq.nlargest(SLOWEST, everything, key=lambda result: result.seconds),
        faults=[(result, check) for result in everything for check in result.checks if check.outcome == "grader_error"],
        absent=[
            {"slug": slug, "who": [student for student in students if (student, slug) not in here]}
            for slug in _slugs(class_results)
        ],
        script=script,
        script_hash=base64.b64encode(hashlib.sha256(script.encode()).digest()).decode(),
    )


def _slugs(class_results: Class) -> list[str]:
    return sorted({slug for _, slug in class_results})


def _here(result: Result) -> bool:
    return result.status != "missing"


def _assignments(class_results: Class, infos: Mapping[str, AssignmentInfo]) -> Iterator[Json]:
    """Yield the statistics of each assignment's scores."""
    handed_in: dict[str, list[Result]] = {slug: [] for slug in _slugs(class_results)}
    for result in filter(_here, class_results.values()):
        handed_in[result.assignment].append(result)
    for slug, mine in handed_in.items():
        scores = [result.score for result in mine if result.score is not None]
        most = mine[0].max_score if mine else 0.0
        bins = [0] * BINS
        for score in scores:
            bins[min(int(BINS * score / most), BINS - 1)] += 1
        yield {
            "slug": slug,
            "title": infos[slug].title,
            "count": len(mine),
            "mean": statistics.fmean(scores) if scores else None,
            "median": statistics.median(scores) if scores else None,
            "full": sum(score == most for score in scores),
            "most": most,
            "bins": bins,
            "highest": max(bins) or 1,
        }


def _scores(class_results: Class, students: Sequence[str], dropped: Container[Key]) -> Iterable[Json]:
    """Yield a row for each student: a cell for each assignment, in parentheses if it is dropped, and the total."""
    slugs = _slugs(class_results)
    for student in students:
        results = {slug: class_results.get((student, slug)) for slug in slugs}
        cells = {slug: _cell(result) for slug, result in results.items()}
        counting = [result.score or 0 for slug, result in results.items() if result and (student, slug) not in dropped]
        shown = [f"({cell})" if cell and (student, slug) in dropped else cell for slug, cell in cells.items()]
        yield {"student": student, "cells": shown, "total": points(sum(counting))}


def _cell(result: Result | None) -> str:
    if result is None or not (_here(result) or result.score):  # a score may be given by hand without a file
        return ""
    if result.status == EXCUSED:
        return EX
    return "error" if result.score is None else points(result.score, result.max_score)


def _tallies(results: Iterable[Result], infos: Mapping[str, AssignmentInfo]) -> list[Json]:
    """Return the statistics of each check over those who handed in, sorted by assignment."""
    counts: dict[tuple[str, str], dict[str, int]] = defaultdict(lambda: dict.fromkeys(OUTCOMES, 0))
    checks, results = dict[tuple[str, str], CheckResult](), list(results)
    upper = _discrimination(results)
    for result in filter(_here, results):
        for check in result.checks:
            key = result.assignment, check.name
            counts[key][check.outcome] += 1
            checks[key] = check
    return [
        {
            "slug": slug,
            "part": check.part,
            "line": infos[slug].lines.get(name, name),
            "points": points(check.max_points),
            "counts": counts[slug, name],
            "share": round(100 * counts[slug, name]["passed"] / sum(counts[slug, name].values()), 1),  # % of passes
            "discrimination": upper.get((slug, name)),
        }
        for (slug, name), check in sorted(checks.items(), key=lambda item: item[0][0])
    ]


def _discrimination(results: Sequence[Result]) -> dict[tuple[str, str], float]:
    """Return for each check the percentage of passes in the best third minus that in the worst third."""
    handed_in: dict[str, list[Result]] = defaultdict(list)
    for result in results:
        if _here(result) and result.score is not None:
            handed_in[result.assignment].append(result)
    shares: dict[tuple[str, str], float] = {}
    for slug, mine in handed_in.items():
        mine.sort(key=lambda result: result.score or 0.0)
        third = len(mine) // 3
        for sign, some in ((-1, mine[:third]), (1, mine[-third:])) if third else ():
            for result in some:
                for check in result.checks:
                    key = slug, check.name
                    shares[key] = shares.get(key, 0.0) + sign * 100 * (check.outcome == "passed") / third
    return {key: round(share, 1) for key, share in shares.items()}


def _suspects(results: Iterable[Result], infos: Mapping[str, AssignmentInfo]) -> list[Json]:
    """Return the mistakes, those of most students first; at equal numbers, known ones before mere failed checks."""
    who: dict[tuple[str, str], set[str]] = defaultdict(set)
    sentences: dict[tuple[str, str], str] = {}
    for result in results:
        for check in result.checks:
            if check.suspect or check.outcome == "failed":
                key = result.assignment, _what_went_wrong(check)
                line = infos[result.assignment].lines.get(check.name, check.name.replace("_", " "))
                sentences[key] = check.suspect or f"{FAILED} {line} {check.message}".strip()
                who[key].add(result.student)
    mistakes = [{"slug": key[0], "key": key[1], "says": sentences[key], "who": sorted(who[key])} for key in who]
    return sorted(mistakes, key=lambda it: (-len(it["who"]), it["says"].startswith(FAILED), it["slug"], it["says"]))


def _what_went_wrong(check: CheckResult) -> str:
    """Return the known mistake of a failed check, else its name and message."""
    return check.suspect or f"{check.name} {check.message}"


def _claims(adjustments: manual_points.ManualAdjustments, course: Path, slugs: Sequence[str]) -> list[Json]:
    """Return for each claim of a rubric how many of the submissions graded by hand satisfy it."""
    claims = []
    for slug in slugs:
        for letter, part in load_rubric(course / "assignments" / slug).items():
            graded = [entry for entry in adjustments.entries.values() if (entry.slug, entry.item) == (slug, letter)]
            comments = [entry.comment.split("\n") for entry in graded if entry.points is not None]
            for worth, claim in part.claims:
                count = sum(f"+ {claim}" in lines for lines in comments)
                about = {"slug": slug, "part": letter, "points": worth, "claim": claim}
                claims.append({**about, "given": count, "of": len(comments)})
    return [entry for entry in claims if entry["of"]]
