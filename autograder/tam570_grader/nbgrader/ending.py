"""How nbgrader's commands end when the gradebook's server is lost, or by Ctrl-C: in one line, nothing half-written."""

import functools
import os
import sys
from pathlib import Path
from typing import Any

from nbgrader.apps.nbgraderapp import NbGraderApp  # type: ignore[import-untyped]
from nbgrader.plugins import CsvExportPlugin  # type: ignore[import-untyped]
from sqlalchemy import event
from sqlalchemy.engine import Engine, ExceptionContext

__all__ = ["Lost", "WholeTable", "end_in_one_line"]

LOST = """nbgrader: error: the gradebook's server {url} does not answer ({why}). Start it, or mend \
CourseDirectory.db_url in nbgrader_config.py; then give the same command again."""


class Lost(KeyboardInterrupt):
    """The server is lost. As after Ctrl-C, nbgrader removes what it was writing and goes on to no other student."""


def end_in_one_line() -> None:
    """From now on a command ends in one line; formgrader's server goes on as it is, for it has other work."""
    if not hasattr(NbGraderApp.start, "__wrapped__"):
        NbGraderApp.start = _ending(NbGraderApp.start)


def _ending(start: Any) -> Any:
    @functools.wraps(start)
    def started(app: Any) -> Any:
        event.listen(Engine, "handle_error", _tell)
        try:
            return start(app)
        except Lost as lost:
            print(lost, file=sys.stderr)
            sys.exit(1)
        except KeyboardInterrupt:
            print("nbgrader: interrupted; what is done is kept: give the same command again", file=sys.stderr)
            sys.exit(130)

    return started


def _tell(context: ExceptionContext) -> None:
    """Raise Lost where the server is what failed; a file is none."""
    if context.engine and context.engine.url.host and (context.is_disconnect or context.connection is None):
        why = str(context.original_exception).strip().partition("\n")[0]
        url = context.engine.url.render_as_string(hide_password=True)
        raise Lost(LOST.format(url=url, why=why)) from None


class WholeTable(CsvExportPlugin):  # type: ignore[misc]
    """nbgrader's table of grades, put in the place of an earlier one when it is whole."""

    def export(self, gradebook: Any) -> None:
        whole = getattr(self, "to") or "grades.csv"  # noqa: B009  its type is traitlets'
        draft = f"{whole}.new"
        self.set_trait("to", draft)
        try:
            super().export(gradebook)
            os.replace(draft, whole)
        finally:
            Path(draft).unlink(missing_ok=True)
