"""Generate an assignment's examples: few comparisons from its checks, with public inputs, that detect known mistakes.

`tam570 check` runs them on a student's computer. Their inputs come from a public seed, not from that of a class. A
comparison that fails a right submission in another style is not released.
"""

import json
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

import numpy as np

from tam570.checking.examples import FILE, Examples, closed, fingerprint, part, plain
from tam570.values import Json, Numbers
from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.expect import check_context
from tam570_grader.checks.returns import Drawing, Formula
from tam570_grader.diagnosis.mistakes import Mistake, mistakes, solution_with
from tam570_grader.errors import say
from tam570_grader.grading.seeds import generator
from tam570_grader.results.tables import written
from tam570_grader.sandbox.pool import Attempt, sandboxes, tried
from tam570_grader.sandbox.student import Source, Student
from tam570_grader.sandbox.zygote import ResourceLimits, Zygote

PUBLIC_SEED = 0xB52C40872108D7BD3A8A619336F349E9  # random, so that no class has it: its inputs are public
MOST_NUMBERS = 160  # most numbers in an example's arguments; its JSON may have 40 characters for each
MOST_OF_A_LABEL = 2  # candidates per function, label of the input and compared member
Example = Json


def write(course: Path, names: Sequence[str]) -> int:
    """Write the examples of these assignments (of all if `names` is empty); return the exit code."""
    with sandboxes():
        for slug in assignments.match_slugs(names, assignments.slugs(course)):
            path = course / "assignments" / slug / FILE
            written(path, examples_of(course, slug))
            say(f"{path} written", error=True)
    return 0


def examples_of(course: Path, slug: str) -> str:
    """Return the text of `examples.json`."""
    assignment = assignments.assignment(course, slug)
    compared = [mistake for mistake in mistakes(assignments.checks_folder(course, slug)) if mistake.text]
    candidates = list(_fair(course, assignment, _candidates(assignment)))
    answers = []  # for each mistake: its result by the number of each example that it fails, None if it raises
    for mistake in compared:
        module, examples = solution_with(assignment.solution, mistake.text), Examples(candidates, ())
        functions = (getattr(module, example["function"], None) for example in candidates)
        wrong = [k for k, function in enumerate(functions) if _wrong(examples, k, function)]
        answers.append({k: examples.results.get(k) for k in wrong})
    failed = [  # by each mistake: the examples of the functions that it changes; if it fails none of these, all others
        {k for k in wrong if candidates[k]["function"] in mistake.defined} or {*wrong}
        for mistake, wrong in zip(compared, answers, strict=True)
    ]
    chosen = _chosen(candidates, failed)
    fingerprints = [_fingerprints(*both, chosen, candidates) for both in zip(compared, answers, strict=True)]
    released = ",\n".join(json.dumps(candidates[k], allow_nan=False) for k in chosen)
    distinguishing = ",\n".join(json.dumps(fingerprint) for fingerprint in fingerprints if fingerprint)
    return f'{{"examples": [\n{released}\n], "mistakes": [\n{distinguishing}\n]}}\n'


def _candidates(assignment: LoadedAssignment) -> list[Example]:
    """Return what the checks compare when they run on the solution with the public seed, a few examples per label."""
    notes: list[Json] = []

    def collect_calls(zygote: Zygote, _: Attempt) -> None:
        student = Student(Source(assignment.solution.encode()), assignment, zygote)
        try:
            student.load()
            for check in assignment.checks:
                with np.errstate(all="ignore"), check_context(aside=student.aside, examples=notes):
                    check.run(student, generator(PUBLIC_SEED, assignment.slug, check))
        finally:
            student.leave()

    tried(collect_calls, sorted(assignment.needs), ResourceLimits(cpu=600, call=100))
    examples: dict[tuple[str, bytes], Example] = {}
    count: dict[tuple[object, ...], int] = {}
    for collected in notes:
        returns, case = assignment.returns[collected["function"]], collected["case"]
        if isinstance(returns, Formula | Drawing):
            continue
        key = collected["function"], case.packed
        if key not in examples:
            label = collected["function"], case.label, collected["compare"]["member"]
            count[label] = count.get(label, 0) + 1
            inputs = (*case.args, *case.kwargs.values())
            size = sum(int(np.size(value)) for value in inputs if not isinstance(value, str))
            if count[label] > MOST_OF_A_LABEL or size > MOST_NUMBERS:
                continue
            args = [plain(value) for value in case.args]
            kwargs = {name: plain(value) for name, value in case.kwargs.items()}
            examples[key] = {"function": key[0], "label": case.label, "args": args, "kwargs": kwargs, "compare": []}
        compare = {}
        for name, value in collected["compare"].items():
            has_numbers = isinstance(value, np.ndarray | np.generic | tuple)
            compare[name] = plain(np.asarray(value, float) if has_numbers else value)
        if compare not in examples[key]["compare"]:
            examples[key]["compare"].append(compare)
    return [value for value in examples.values() if len(json.dumps(value)) < 40 * MOST_NUMBERS]


def _fair(course: Path, assignment: LoadedAssignment, candidates: Sequence[Example]) -> Iterator[Example]:
    """Yield the candidates that the solution and all right submissions in other styles pass."""
    texts = ["", *assignments.alternatives(course, assignment.slug).values()]
    modules = [solution_with(assignment.solution, text) for text in texts]
    examples = Examples(candidates, ())
    for k, candidate in enumerate(candidates):
        if not any(_wrong(examples, k, getattr(module, candidate["function"], None)) for module in modules):
            yield candidate


def _wrong(examples: Examples, number: int, function: Any) -> bool:
    try:
        with np.errstate(all="ignore"):
            examples.run(function, number)
    except Exception:  # a wrong function may raise anything
        return True
    return False


def _chosen(candidates: Sequence[Example], wrong: Sequence[set[int]]) -> list[int]:
    """Return few examples, chosen greedily, such that each mistake fails one of them and each function has one."""
    unmet = [*filter(None, wrong)]
    functions = dict.fromkeys(example["function"] for example in candidates)
    unmet += [{k for k, other in enumerate(candidates) if other["function"] == name} for name in functions]
    chosen: list[int] = []
    while unmet:
        best = max(range(len(candidates)), key=lambda k: sum(k in unmet_by for unmet_by in unmet))
        chosen.append(best)
        unmet = [unmet_by for unmet_by in unmet if best not in unmet_by]
    return sorted(chosen)


def _fingerprints(
    mistake: Mistake, answers: Mapping[int, Numbers], chosen: Sequence[int], candidates: Sequence[Example]
) -> Json | None:
    """Return data to recognize a mistake of one function by its results in the chosen examples; None if impossible."""
    results: dict[str, list[float] | None] = {}
    changed = {candidates[k]["function"] for k in answers} & mistake.defined
    if len(changed) != 1 or not mistake.compared:
        return None
    (function,) = changed
    for number, k in enumerate(chosen):
        compare = candidates[k]["compare"]
        if k in answers and candidates[k]["function"] == function and not any(each.get("raises") for each in compare):
            results[str(number)] = None
            if answers[k] is not None:
                numbers = [fingerprint(part(answers[k], each)) for each in compare]
                if not np.isfinite(numbers).all():
                    return None
                results[str(number)] = [float(f"{x:.9g}") for x in numbers]
    if not any(results.values()):
        return None
    return {"function": function, "message": closed(mistake.message), "results": results}
