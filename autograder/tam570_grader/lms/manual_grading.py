"""Web pages to grade by hand (`tam570-grader mark`), which are served only to this machine, at a secret address.

Saving writes rows of by_hand.csv: the points of each part, and a comment that lists the satisfied claims of the rubric.
Nothing else is stored.
"""

import contextlib
import json
import mimetypes
import random
import secrets
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Lock

from tam570.values import Json
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.errors import UsageError, writing
from tam570_grader.grading.archives import is_beside
from tam570_grader.grading.submissions import CannotRead, Submission, entries, packed_files, read
from tam570_grader.reports.feedback import template
from tam570_grader.results import manual_points
from tam570_grader.results.collected import is_zip
from tam570_grader.results.manual_points import EVERYONE, Entry
from tam570_grader.results.store import ResultStore
from tam570_grader.sandbox.notebooks import Unshown, cells_of

SHOWN = (".png", ".jpg", ".jpeg", ".gif", ".svg")
HEADERS = {
    "Content-Security-Policy": "default-src 'none'; img-src 'self' data:; style-src 'unsafe-inline'; "
    "script-src 'nonce-{nonce}'; connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'",
    "X-Content-Type-Options": "nosniff",
    "Referrer-Policy": "no-referrer",
    "Cache-Control": "no-store",
}
LARGEST = 100_000  # bytes, largest request
NOT_AT_HAND = "The work is not at hand: name its tree with --submitted."


@dataclass(frozen=True)
class StudentWork:
    """One student's work on one assignment, with the parts that are graded by hand."""

    student: str
    slug: str
    parts: Mapping[str, ManualPart]
    submission: Submission | None = None


class Desk:
    """All work in a folder of results that must be graded by hand."""

    def __init__(self, folder: Path, works: Sequence[StudentWork], *, anonymous: bool = False) -> None:
        self.folder, self.works, self.anonymous = folder, list(works), anonymous
        if anonymous:
            random.SystemRandom().shuffle(self.works)
        self._lock = Lock()

    def name(self, number: int) -> str:
        return f"Student {number + 1}" if self.anonymous else self.works[number].student

    def save(self, number: int, part: str, claims: Sequence[int], points: float | None, comment: str) -> float:
        """Store and return the points of a part: `points` if given, else the sum of the ticked claims."""
        work = self.works[number]
        rubric = work.parts[part]
        ticked = [rubric.claims[claim] for claim in sorted({*claims})]
        earned = round(sum(worth for worth, _ in ticked), 6) if points is None else points
        if not 0 <= earned <= rubric.points:
            raise ValueError(f"part ({part}) has from 0 to {rubric.points:g} points")
        text = "\n".join([*(f"+ {claim}" for _, claim in ticked), *([comment.strip()] if comment.strip() else [])])
        rows = [
            Entry(work.student, work.slug, part, earned, rubric.points, text),
            *(Entry(EVERYONE, work.slug, letter, None, entry.points) for letter, entry in work.parts.items()),
        ]
        with self._lock, writing(self.folder), contextlib.closing(ResultStore(self.folder)):
            manual_points.write(self.folder, manual_points.read(self.folder).with_(rows))
        return earned

    def files(self, number: int) -> list[tuple[str, Callable[[], bytes]]]:
        """Return names and readers of drawings and texts beside the work or in its zip file, without links."""
        submission = self.works[number].submission
        if submission is None or submission.path is None:
            return []
        held = [path for path, is_folder in entries(submission.path.parent) if not is_folder and not path.is_symlink()]
        files: list[tuple[str, Callable[[], bytes]]] = [
            (path.name, path.read_bytes) for path in held if is_beside(path.name) and path.is_file()
        ]
        with contextlib.suppress(CannotRead):  # `code` shows why
            for file in packed_files(submission) if is_zip(submission.path.name) else ():
                if file.refused or is_beside(file.path):
                    name = f"{file.path} ({file.refused})" if file.refused else file.path
                    files.append((name, partial(bytes, file.data)))
        return files

    def code(self, number: int) -> list[tuple[str, str]]:
        """Return (kind, text) pairs of the work: the module, or a notebook's cells; a note if it cannot be read."""
        submission = self.works[number].submission
        if submission is None or submission.path is None:
            return [("note", submission.reason if submission else NOT_AT_HAND)]
        try:
            source = read(submission)
            if not source.notebook:
                return [("code", source.text.decode("utf-8", "replace"))]
            return [(str(cell["kind"]), str(cell["source"])) for cell in cells_of(source.text)]
        except (CannotRead, Unshown) as why:
            return [("note", str(why))]


def serve(desk: Desk, port: int = 0) -> tuple[ThreadingHTTPServer, str]:
    """Return a server that only this machine can reach, and the address of the first page with its secret token."""
    token = secrets.token_urlsafe(24)
    handler = type("Handler", (_Handler,), {"desk": desk, "token": token})
    try:
        server = ThreadingHTTPServer(("127.0.0.1", port), handler)
    except (OSError, OverflowError) as error:
        raise UsageError(f"--port {port}: {error}; leave it out for any that is free") from None
    server.daemon_threads = True
    return server, f"http://127.0.0.1:{server.server_address[1]}/{token}/0"


class _Handler(BaseHTTPRequestHandler):
    desk: Desk
    token: str
    server: ThreadingHTTPServer

    def do_GET(self) -> None:
        """Answer with a student's page, or with a file that it shows or links to."""
        path = self._path()
        if path is None:
            return self._send(404, "text/plain", b"not found")
        number = int(path[0])
        if len(path) == 1:
            nonce = secrets.token_urlsafe(16)
            return self._send(200, "text/html; charset=utf-8", page(self.desk, number, nonce).encode(), nonce)
        files = self.desk.files(number)
        if len(path) == 2 and path[1].isdecimal() and int(path[1]) < len(files):
            name, content = files[int(path[1])]
            mime_type = mimetypes.guess_type(name)[0] or "application/octet-stream"
            is_shown = name.lower().endswith(SHOWN)
            return self._send(200, mime_type if is_shown else "application/octet-stream", content())
        return self._send(404, "text/plain", b"not found")

    def do_POST(self) -> None:
        """Save the points of a part, and answer with them."""
        path = self._path()
        length = int(self.headers.get("Content-Length") or 0)
        if path is None or len(path) != 1 or length > LARGEST:
            return self._send(404, "text/plain", b"not found")
        try:
            request: Json = json.loads(self.rfile.read(length))
            points = None if request.get("points") in (None, "") else float(request["points"])
            claims = [int(number) for number in request.get("claims", [])]
            earned = self.desk.save(int(path[0]), str(request["part"]), claims, points, str(request.get("comment", "")))
        except (ValueError, KeyError, IndexError, TypeError, UsageError) as error:
            return self._send(400, "text/plain; charset=utf-8", str(error).encode())
        return self._send(200, "application/json", json.dumps({"points": earned}).encode())

    def _path(self) -> list[str] | None:
        """Return the path after the secret token; None if token, Host header or number of the student is wrong."""
        _, token, *rest = [*self.path.split("?")[0].split("/"), ""]
        rest = [part for part in rest if part]
        host = f"127.0.0.1:{self.server.server_port}"
        ours = secrets.compare_digest(token.encode(), self.token.encode()) and self.headers.get("Host") == host
        is_student = bool(rest) and rest[0].isdecimal() and int(rest[0]) < len(self.desk.works)
        return rest if ours and is_student else None

    def _send(self, code: int, mime_type: str, body: bytes, nonce: str = "") -> None:
        self.send_response(code)
        for name, value in HEADERS.items():
            self.send_header(name, value.format(nonce=nonce))
        self.send_header("Content-Type", mime_type)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        self.wfile.write(body)

    def log_message(self, format: str, *args: object) -> None:  # noqa: A002  its name is the library's
        """Print nothing: the address contains the secret token."""


def page(desk: Desk, number: int, nonce: str) -> str:
    """Return one student's page."""
    work, last, entries = desk.works[number], len(desk.works) - 1, manual_points.read(desk.folder).entries
    return template("mark.html").render(
        title=f"{desk.name(number)}, {work.slug}",
        count=f"{number + 1} of {last + 1}",
        previous=max(0, number - 1),
        following=min(last, number + 1),
        parts=[
            _part(entries.get((work.student, work.slug, letter)), letter, rubric)
            for letter, rubric in work.parts.items()
        ],
        number=number,
        code=desk.code(number),
        files=[(name, name.lower().endswith(SHOWN)) for name, _ in desk.files(number)],
        nonce=nonce,
    )


def _part(entry: Entry | None, letter: str, rubric: ManualPart) -> Json:
    """Return what a page shows of a part: claims with ticks, points (`typed` if not their sum), rest of the comment."""
    lines, texts = entry.comment.split("\n") if entry else [], {f"+ {claim}" for _, claim in rubric.claims}
    points = entry.points if entry else None
    ticked = [f"+ {claim}" in lines for _, claim in rubric.claims]
    of_claims = round(sum(worth for (worth, _), is_ticked in zip(rubric.claims, ticked, strict=True) if is_ticked), 6)
    return {
        "letter": letter,
        "rubric": rubric,
        "claims": [(worth, claim, is_ticked) for (worth, claim), is_ticked in zip(rubric.claims, ticked, strict=True)],
        "given": points,
        "typed": "" if points is None or points == of_claims else f"{points:g}",
        "comment": "\n".join(line for line in lines if line not in texts),
    }
