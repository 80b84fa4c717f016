"""Open nbgrader's gradebook once per command; nbgrader opens it and checks its tables ten times per submission."""

import functools
from typing import Any

from nbgrader.api import Gradebook  # type: ignore[import-untyped]
from nbgrader.converters import autograde  # type: ignore[import-untyped]
from nbgrader.preprocessors import latesubmissions, overwritecells, overwritekernelspec, saveautogrades  # type: ignore[import-untyped]
from sqlalchemy.orm import scoped_session, sessionmaker

OPENERS = (autograde, latesubmissions, overwritecells, overwritekernelspec, saveautogrades)


class OpenGradebook(Gradebook):  # type: ignore[misc]
    """A gradebook with a new session on a cached engine, so that connection and compiled queries are reused."""

    def __init__(self, db_url: str, course_id: str = "default_course", authenticator: Any = None) -> None:
        self.engine = _engine(db_url, course_id)
        self.db = scoped_session(sessionmaker(autoflush=True, bind=self.engine, future=True))
        self.course_id, self.authenticator = course_id, authenticator

    def close(self) -> None:
        """End the session."""
        self.db.remove()


@functools.cache
def _engine(db_url: str, course_id: str) -> Any:
    """Return the engine of a gradebook, after its tables and its course are created."""
    with Gradebook(db_url, course_id) as gradebook:
        return gradebook.engine


def keep_gradebooks_open() -> None:
    """Let autograde use OpenGradebook from now on, with new engines (a server may have run an earlier command)."""
    _engine.cache_clear()
    for module in OPENERS:
        module.Gradebook = OpenGradebook
