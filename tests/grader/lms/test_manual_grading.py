"""The page for grading by hand answers only at its address, and writes rows of `points`."""

import json
import shutil
import threading
import urllib.error
import urllib.request

import pytest
from classes import hand_in, packed

from tam570_grader import cli
from tam570_grader.checks.rubric import ManualPart
from tam570_grader.errors import UsageError
from tam570_grader.grading import archives
from tam570_grader.grading import submissions as submission_files
from tam570_grader.grading.submissions import submissions
from tam570_grader.lms.manual_grading import Desk, StudentWork, serve
from tam570_grader.results import manual_points

SLUG = "hw07_double_pendulum"
RUBRIC = {"c": ManualPart("why", ((0.5, "It has a reason."), (1.5, "It draws <b>it</b>.")))}


@pytest.fixture(scope="module")
def graded(course, tmp_path_factory):
    """Return the folder of a graded class: ann's zip file with a picture in and beside it, and nothing from ben."""
    tmp_path = tmp_path_factory.mktemp("graded")
    work = packed({f"{SLUG}.py": "# </pre><script>alert(1)</script>", "c.png": "in it"})
    folder = hand_in(tmp_path / "submitted", {"ann": work}, SLUG, "{0}/a.zip") / "ann" / SLUG
    (folder / "a.png").write_bytes(b"\x89PNG")
    (folder / "b.svg").symlink_to("/etc/passwd")
    (tmp_path / "roster").write_text("ann\nben\n")
    grade = ["grade", str(tmp_path / "submitted"), "--out", str(tmp_path / "results"), "--seed", "1"]
    assert cli.main(["--root", str(course), *grade, "--roster", str(tmp_path / "roster")]) == 0
    return tmp_path


@pytest.fixture
def desk(graded, tmp_path):
    shutil.copytree(graded, tmp_path, symlinks=True, dirs_exist_ok=True)
    (work,) = submissions([tmp_path / "submitted"], [SLUG])
    built = Desk(tmp_path / "results", [StudentWork("ann", SLUG, RUBRIC, work), StudentWork("ben", SLUG, RUBRIC)])
    server, address = serve(built)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    yield built, address
    server.shutdown()
    server.server_close()


def ask(address, reported=None, **headers):
    """Return status, headers and text of the answer to a request, which posts `reported` as JSON if present."""
    data = None if reported is None else json.dumps(reported).encode()
    try:
        with urllib.request.urlopen(urllib.request.Request(address, data, headers)) as answer:
            return answer.status, answer.headers, answer.read().decode(errors="replace")
    except urllib.error.HTTPError as error:
        return error.code, error.headers, error.read().decode()


def test_the_page_shows_the_work_and_runs_nothing_of_it(desk):
    _, address = desk
    status, headers, text = ask(address)
    assert status == 200 and "&lt;script&gt;" in text and "<script>alert" not in text and "draws &lt;b&gt;" in text
    assert "default-src 'none'" in headers["Content-Security-Policy"] and "passwd" not in text
    assert ask(f"{address}/0")[2].startswith("\ufffdPNG") and ask(f"{address}/1")[2] == "in it"
    assert ask(f"{address}/2")[0] == 404


def test_a_page_and_its_drawings_unpack_a_zip_file_once(desk, monkeypatch):
    calls, real = [], archives.unpack_zip
    monkeypatch.setattr(archives, "unpack_zip", lambda *arguments: calls.append(1) or real(*arguments))
    submission_files._unpacked.cache_clear()
    for address in (desk[1], f"{desk[1]}/0", f"{desk[1]}/1"):
        ask(address)
    assert len(calls) == 1


def test_nobody_else_is_answered(desk):
    _, address = desk
    token = address.split("/")[3]
    others = [address.replace(token, "x"), address.replace(f"/{token}", ""), f"{address}9", f"{address}/../../etc"]
    assert [ask(item)[0] for item in others] == [404] * 4
    assert ask(address, Host="evil.example")[0] == 404


def test_points_are_rows_of_the_table(desk):
    built, address = desk
    reported = {"part": "c", "claims": [1, 1], "points": "", "comment": "Well drawn."}
    assert ask(address, reported)[0] == 200
    row = manual_points.read(built.folder).entries["ann", SLUG, "c"]
    assert (row.points, row.of, row.comment) == (1.5, 2.0, "+ It draws <b>it</b>.\nWell drawn.")
    assert "ann,hw07_double_pendulum,graded,1.5,12.0" in (built.folder / "grades.csv").read_text()
    _, _, text = ask(address)
    assert 'value="1" checked' in text and 'value="0" checked' not in text and ">Well drawn.</textarea>" in text
    assert ask(address, {**reported, "points": "1.75"})[0] == 200
    assert manual_points.read(built.folder).entries["ann", SLUG, "c"].points == 1.75


def test_a_port_that_is_taken_is_named(desk):
    built, address = desk
    for port in (int(address.split("/")[2].partition(":")[2]), 99999):
        with pytest.raises(UsageError, match=f"--port {port}"):
            serve(built, port)


@pytest.mark.parametrize("odd", [{"points": "3"}, {"points": "nan"}, {"claims": [7]}, {"part": "z"}, {"claims": "x"}])
def test_what_is_wrong_is_not_written(desk, odd):
    built, address = desk
    assert ask(address, {"part": "c", "claims": [], "points": "", **odd})[0] == 400
    assert not manual_points.read(built.folder).entries
