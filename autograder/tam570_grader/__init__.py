"""The grading engine of tam570; also the names that hidden checks import."""

import os
from typing import TYPE_CHECKING

if os.name != "posix":
    raise SystemExit("tam570-grader: error: the grader needs Linux or macOS; on Windows, use WSL")
# must be set before NumPy is imported; for matrices this small, BLAS threads cost more CPU time than all else
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

if TYPE_CHECKING:
    from collections.abc import Iterable, Iterator
    from pathlib import Path

    from tam570_grader.checks.public import *  # noqa: F403
    from tam570_grader.grading.batch import RunConfig
    from tam570_grader.results.records import Result
else:

    def __getattr__(name):
        """Import the vocabulary of checks at first use, so that a command can start its sandbox before."""
        from tam570_grader.checks import public

        return getattr(public, name)


def grade(submissions: "Iterable[str | Path]", config: "RunConfig | None" = None) -> "Iterator[Result]":
    """Grade submissions in the sandbox.

    Parameters
    ----------
    submissions : paths
        Modules, notebooks, zip files, their folders, or trees `<student>/<assignment>/`, as for `tam570-grader grade`.
    config : RunConfig, optional
        Course, seed, processes, limits. By default the installed course, a random seed, one process per core.

    Yields
    ------
    Result
        Student, assignment, status, score and checks of each submission, as soon as it is graded.

    Raises
    ------
    UsageError
        If there is no submission at these paths, or if this machine cannot confine submissions.

    Examples
    --------
    >>> from tam570_grader.checks import assignments
    >>> for result in grade([assignments.find() / "solutions" / "hw08_axis_angle.py"]):
    ...     print(result.assignment, result.score, [check.outcome for check in result.checks][:2])
    hw08_axis_angle 10.0 ['passed', 'passed']
    """
    from tam570_grader.grading import batch

    return batch.grade(submissions, config or batch.RunConfig())
