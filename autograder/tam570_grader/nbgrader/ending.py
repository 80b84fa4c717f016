"""End nbgrader's commands with one line and no partial files if the gradebook is lost or locked, or on Ctrl-C."""

import functools
import os
import sqlite3
import sys
from pathlib import Path
from typing import Any, TypeAlias

from nbgrader.apps.nbgraderapp import NbGraderApp  # type: ignore[import-untyped]
from nbgrader.plugins import CsvExportPlugin  # type: ignore[import-untyped]
from sqlalchemy import event
from sqlalchemy.engine import Engine, ExceptionContext

from tam570_grader.errors import say

Nbgrader: TypeAlias = Any  # an application, connection or gradebook; nbgrader has no types

LOST = """nbgrader: error: the gradebook's server {url} does not answer ({why}). Start it, or mend \
CourseDirectory.db_url in nbgrader_config.py; then give the same command again."""


LOCKED = """nbgrader: error: the gradebook {url} is locked by another command for more than {wait} s ({why}); nothing \
is lost: give the same command again."""
WAIT = 60  # s; SQLite's default is 5


class Lost(KeyboardInterrupt):
    """The gradebook is lost or locked; as on Ctrl-C, nbgrader removes what it was writing and does no other student."""


def end_in_one_line() -> None:
    """Patch nbgrader so that its commands end with one line; formgrader's server, which is no command, is unchanged."""
    if not hasattr(NbGraderApp.start, "__wrapped__"):
        NbGraderApp.start = _ending(NbGraderApp.start)


def _ending(start: Nbgrader) -> Nbgrader:
    @functools.wraps(start)
    def started(app: Nbgrader) -> Nbgrader:
        event.listen(Engine, "handle_error", _tell)
        event.listen(Engine, "connect", _wait)
        try:
            return start(app)
        except Lost as lost:
            say(str(lost), error=True)
            sys.exit(1)
        except KeyboardInterrupt:
            say("nbgrader: interrupted; what is done is kept: give the same command again", error=True)
            sys.exit(130)

    return started


def _tell(context: ExceptionContext) -> None:
    """Raise Lost if the gradebook's server does not answer, or if the gradebook stays locked."""
    if context.engine and context.engine.url.host and (context.is_disconnect or context.connection is None):
        why = str(context.original_exception).strip().partition("\n")[0]
        url = context.engine.url.render_as_string(hide_password=True)
        raise Lost(LOST.format(url=url, why=why)) from None
    if context.engine and "database is locked" in str(context.original_exception):
        url = context.engine.url.render_as_string(hide_password=True)
        raise Lost(LOCKED.format(url=url, wait=WAIT, why=context.original_exception)) from None


def _wait(connection: Nbgrader, _: Nbgrader) -> None:
    """Let SQLite wait up to WAIT for another command that writes."""
    if isinstance(connection, sqlite3.Connection):
        connection.execute(f"PRAGMA busy_timeout = {round(1000 * WAIT)}")


class WholeTable(CsvExportPlugin):  # type: ignore[misc]
    """nbgrader's export of grades, except that it replaces an earlier table atomically."""

    def export(self, gradebook: Nbgrader) -> None:
        target = getattr(self, "to") or "grades.csv"  # noqa: B009  its type is traitlets'
        draft = f"{target}.new"
        self.set_trait("to", draft)
        try:
            super().export(gradebook)
            os.replace(draft, target)
        finally:
            Path(draft).unlink(missing_ok=True)
