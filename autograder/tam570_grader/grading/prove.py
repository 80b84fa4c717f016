"""Test the checks that a course adds before they grade anybody."""

from collections.abc import Sequence
from pathlib import Path

from tam570_grader.checks import assignments
from tam570_grader.checks.assignments import ADDITIONS
from tam570_grader.course.course_config import resource_limits
from tam570_grader.errors import UsageError
from tam570_grader.grading import supervisor
from tam570_grader.grading.supervisor import GradeTask, WorkerConfig
from tam570_grader.sandbox.student import Source

SEEDS = 3  # number of seeds with which the solution and the stub are graded


def prove(root: Path, slugs: Sequence[str]) -> None:
    """Raise UsageError if the solution fails or the stub passes a check that the course added; record each success."""
    for slug in slugs:
        added, proved = assignments.checks_folder(root, slug) / f"{ADDITIONS}.py", root / f".proved-{slug}"
        if not added.is_file() or proved.exists():
            continue
        config = WorkerConfig(resource_limits(root), (root,))
        assignment = assignments.assignment(root, slug)
        added_names = {check.name for check in assignment.checks if check.run.__module__.endswith(f".{ADDITIONS}")}
        stub = root / "assignments" / slug / f"{slug}.py"
        texts = {"solution": assignment.solution, "stub": stub.read_text("utf-8")}
        for what, text in texts.items():
            for seed in range(SEEDS):
                task = GradeTask(root, what, slug, seed, Source(text.encode(), notebook=False), conditions=config)
                for result in supervisor.result(task).checks:
                    if result.name in added_names and (result.outcome == "passed") != (what == "solution"):
                        reason = result.message or result.error or result.outcome
                        why = f"the solution fails it: {reason}" if what == "solution" else "the stub passes it"
                        raise UsageError(f"your check {result.name} of {slug}: {why.rstrip('.')}; mend the check")
        proved.touch()
