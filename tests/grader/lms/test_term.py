"""A term: sixty students, three assignments, from Canvas's zip files to the tables that Canvas and Moodle import."""

import csv
import zipfile

import pytest

from tam570_grader import cli
from tam570_grader.results.records import FORMAT
from tam570_grader.results.store import RESULT_FIELDS, ResultStore

SLUGS = "hw03_angular_momentum_rate", "hw08_axis_angle", "hw09_book"
CLASS = range(60)


def login(n):
    return f"net{n:02}"


def score(n, k):
    """What student n has in assignment k: another number for everybody."""
    return round((n + k / 4) / 10, 3)


@pytest.fixture
def desk(tmp_path, monkeypatch, course):
    """An empty folder with the rosters; `command(...)` runs the grader there."""
    monkeypatch.chdir(tmp_path)
    heading = "Student,ID,SIS User ID,SIS Login ID,Section," + ",".join(
        f"{slug} ({70 + k})" for k, slug in enumerate(SLUGS)
    )
    lines = [f'"Last{n}, First",{1000 + n},S{n},{login(n)},570,,,' for n in CLASS]
    (tmp_path / "canvas.csv").write_text("\n".join([heading, "    Points Possible,,,,,10,10,10", *lines]))
    lines = [f"First,Last{n},{login(n)},S{n},{login(n)}@x.edu" for n in CLASS]
    (tmp_path / "moodle.csv").write_text("\n".join(["First name,Last name,Username,ID number,Email address", *lines]))
    return lambda *command: cli.main(["--root", str(course), *command])


def download(path, slug, late=()):
    """What Canvas hands out: two versions by every third student."""
    with zipfile.ZipFile(path, "w") as archive:
        for n in CLASS:
            mark = "LATE_" if n in late else ""
            archive.writestr(f"lastfirst_{mark}{1000 + n}_{2000 + n}_{slug}.py", f"# {n}\n")
            if n % 3 == 0:
                archive.writestr(f"lastfirst_{mark}{1000 + n}_{3000 + n}_{slug}-2.py", f"# {n}, again\n")


def rows(path):
    with open(path, newline="") as file:
        return list(csv.reader(file))


def graded(folder):
    """Results as `grade` writes them, made from what was collected."""
    book = ResultStore(folder / "results")
    for path in sorted((folder / "submitted").glob("*/*/*.py")):
        n, slug = int(path.parts[-3].removeprefix("net")), path.parts[-2]
        assert path.read_text() == (f"# {n}, again\n" if n % 3 == 0 else f"# {n}\n")
        known = {
            "student": login(n),
            "assignment": slug,
            "status": "graded",
            "max_score": 10.0,
            "checks": [],
            "seed": 1,
        }
        book.add({**dict.fromkeys(RESULT_FIELDS, 0), "format": FORMAT, **known, "score": score(n, SLUGS.index(slug))})
    book.close()


def test_sixty_students_from_canvas_to_canvas_and_moodle(desk, tmp_path):
    for slug in SLUGS:
        download(tmp_path / "download.zip", slug, late=(7,))
        assert desk("collect", "download.zip", "--from", "canvas", "--roster", "canvas.csv") == 0
    graded(tmp_path)
    lms = "lms", "results/grades.csv", "--ungraded", "zero"
    assert desk(*lms, "--to", "canvas", "--roster", "canvas.csv", "--out", "up.csv") == 0
    heading, possible, *people = rows(tmp_path / "up.csv")
    assert heading == rows(tmp_path / "canvas.csv")[0] and possible[5:] == ["10"] * 3
    points = [[str(score(n, k)) for k in range(3)] for n in CLASS]
    assert people == [[f"Last{n}, First", str(1000 + n), f"S{n}", login(n), "570", *points[n]] for n in CLASS]
    for identity, who in (("username", login), ("idnumber", "S{}".format), ("email", lambda n: f"{login(n)}@x.edu")):
        where = "--roster", "moodle.csv", "--identity", identity
        assert desk(*lms, "--to", "moodle", *where, "--out", "up.csv") == 0
        assert rows(tmp_path / "up.csv")[1:] == [[who(n), *points[n]] for n in CLASS]


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_left_out_is_named_and_the_code_is_1(desk, tmp_path, capsys, system):
    (tmp_path / "grades.csv").write_text(
        "student,assignment,score,max_score\n"
        + "".join(f"{login(n)},hw08_axis_angle,9,10\n" for n in CLASS if n != 4)
        + "ghost,hw08_axis_angle,9,10\n"
    )
    code = desk("lms", "grades.csv", "--to", system, "--roster", f"{system}.csv", "--out", "up.csv")
    err = capsys.readouterr().err
    assert code == 1 and err.count("warning: ") == 2
    assert "ghost has scores and is on no row of the roster" in err and "(net04) has no score in hw08_axis_angle" in err


def test_moodles_table_without_the_column_asked_for_is_refused(desk, tmp_path, capsys):
    (tmp_path / "grades.csv").write_text("student,assignment,score,max_score\nnet01,hw08_axis_angle,9,10\n")
    assert desk("lms", "grades.csv", "--to", "moodle", "--roster", "canvas.csv") == 2
    assert "no column Username" in capsys.readouterr().err
