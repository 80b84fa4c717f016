"""The grading engine of tam570, and, for the checks files, all that hidden checks are written with."""

import os
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING

if os.name != "posix":
    raise SystemExit("tam570-grader: error: the grader needs Linux or macOS; on Windows, use WSL")
# before NumPy is there: a second thread for matrices this small costs more processor time than all the rest
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

if TYPE_CHECKING:
    from tam570_grader.checks.public import *  # noqa: F403
    from tam570_grader.grading.batch import RunConfig
    from tam570_grader.results.records import Result
else:

    def __getattr__(name):
        """Import what checks are written with when they need it: a command starts its sandbox before."""
        from tam570_grader.checks import public

        return getattr(public, name)


def grade(submissions: "Iterable[str | Path]", config: "RunConfig | None" = None) -> "Iterator[Result]":
    """Grade submissions in the sandbox.

    Parameters
    ----------
    submissions : paths
        Modules, notebooks, their folders, or trees `<student>/<assignment>/`, as `tam570-grader grade` takes them.
    config : RunConfig, optional
        Course, seed, supervisors, limits. By default the installed course, a random seed, a supervisor a core.

    Yields
    ------
    Result
        Of each submission, as soon as it is graded: student, assignment, status, score, checks.

    Raises
    ------
    UsageError
        Where there is no submission at these paths, or no submission can be confined on this machine.

    Examples
    --------
    >>> from tam570_grader.checks import assignments
    >>> for result in grade([assignments.find() / "solutions" / "hw08_axis_angle.py"]):
    ...     print(result.assignment, result.score, [check.outcome for check in result.checks][:2])
    hw08_axis_angle 10.0 ['passed', 'passed']
    """
    from tam570_grader.grading import batch

    return batch.grade(submissions, config or batch.RunConfig())
