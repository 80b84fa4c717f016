"""A term that is graded: sixty students' modules, from zip files of Canvas and Moodle to what both import."""

import csv
import zipfile

import pytest

from tam570_grader import cli
from tam570_grader.diagnosis.mistakes import overlays

pytestmark = pytest.mark.slow  # 180 submissions in the sandbox
SEED = 570
LATE = 7  # days, of student 11, in every assignment
CLASS = range(60)
MISTAKES = {
    "hw03_angular_momentum_rate": ("moment_about_the_origin", "rate_c_with_both_terms", "rate_b_by_c"),
    "hw08_axis_angle": ("transposed_skew", "zero_axis_is_no_rotation", "rotate_changes_r"),
    "hw09_book": ("axis_rotation", "space_sequence", "axis_angle"),
}
SLUGS = tuple(MISTAKES)


def login(n):
    return f"net{n:02}"


def which(n, slug):
    """The file that student n hands in: no two students hand in the same three."""
    return n // 4 ** SLUGS.index(slug) % 4


@pytest.fixture
def texts(course, solution_text):
    """Of each assignment a right module and three wrong ones."""
    found = {}
    for slug, names in MISTAKES.items():
        checks = course / "autograder" / "checks" / slug
        wrong = [f"{solution_text(slug)}\n\n{overlays(checks)[name]}" for name in names]
        found[slug] = [(checks / "alternatives" / "independent.py").read_text(), *wrong]
    return found


@pytest.fixture
def scores(texts, grade):
    """What each student earns: the file alone is graded, without names, folders or tables."""
    alone = {slug: [grade(slug, text, SEED).score for text in texts[slug]] for slug in SLUGS}
    assert all(len(set(found)) == 4 and found[0] == 10 for found in alone.values())  # else rows could be exchanged
    return {n: [alone[slug][which(n, slug)] for slug in SLUGS] for n in CLASS}


@pytest.fixture
def rosters(tmp_path, monkeypatch):
    """An empty folder with the tables that Canvas and Moodle export, in another order than the submissions."""
    monkeypatch.chdir(tmp_path)
    columns = ",".join(f"{slug} ({70 + k})" for k, slug in enumerate(SLUGS))
    canvas = [f'"Last{n}, First",{1000 + n},S{n},{login(n)},570,,,' for n in reversed(CLASS)]
    top = ["Student,ID,SIS User ID,SIS Login ID,Section," + columns, "    Points Possible,,,,,10,10,10"]
    (tmp_path / "canvas.csv").write_text("\n".join([*top, *canvas]))
    moodle = [f"First,Last{n},{login(n)},S{n},Participant {5000 + n}" for n in reversed(CLASS)]
    (tmp_path / "moodle.csv").write_text("\n".join(["First name,Last name,Username,ID number,Identifier", *moodle]))


def canvas_zip(path, slug, texts):
    """Every third student handed in something else before."""
    with zipfile.ZipFile(path, "w") as archive:
        for n in CLASS:
            start = f"last{n}first_{'LATE_' if n == 11 else ''}{1000 + n}"
            if n % 3 == 0:
                archive.writestr(f"{start}_{2000 + n}_{slug}.py", "# nothing yet\n")
            again = "-1" if n % 3 == 0 else ""
            archive.writestr(f"{start}_{9000 - n}_{slug}{again}.py", texts[slug][which(n, slug)])


def moodle_zip(path, slug, texts):
    with zipfile.ZipFile(path, "w") as archive:
        for n in CLASS:
            name = f"First Last{n}_{5000 + n}_assignsubmission_file_/{slug}.py"
            archive.writestr(name, texts[slug][which(n, slug)])


def ours(*command):
    return cli.main([str(part) for part in command])


def people(path):
    """The rows by login, without Canvas's own row of points."""
    with open(path, newline="") as file:
        heading, *rows = csv.reader(file)
    names = 3 if heading[0] == "Student" else 0
    return {row[names]: row[-3:] for row in rows if row[names]}


def files(folder):
    return {path.relative_to(folder): path.read_bytes() for path in folder.rglob("*.py")}


def test_sixty_students_from_zip_files_to_uploads(tmp_path, rosters, texts, scores):
    for slug in SLUGS:
        for system, pack in (("canvas", canvas_zip), ("moodle", moodle_zip)):
            pack(tmp_path / "download.zip", slug, texts)
            to = "--roster", f"{system}.csv", "--to", f"{system}/submitted"
            assert ours("collect", "download.zip", "--from", system, *to) == 0
    assert files(tmp_path / "canvas" / "submitted") == files(tmp_path / "moodle" / "submitted")
    assert ours("grade", "canvas/submitted", "--out", "results", "--seed", SEED) == 0

    added = [f"{login(4)},hw08,adjust,-0.5,It was copied.", f"{login(5)},hw09,total,7,It was shown in class."]
    added += [f"{login(11)},{slug},late,{LATE}," for slug in SLUGS] + [f"*,{slug},off a day,.1," for slug in SLUGS]
    (tmp_path / "points.csv").write_text("\n".join(["student,assignment,item,points,comment", *added]))
    assert ours("points", "results", "points.csv") == 0
    scores[4][1] -= 0.5
    scores[5][2] = 7.0
    scores[11] = [round(score * (1 - LATE * 0.1), 6) for score in scores[11]]

    for system in ("canvas", "moodle"):
        assert (
            ours(
                "lms",
                "results/grades.csv",
                "--ungraded",
                "zero",
                "--to",
                system,
                "--roster",
                f"{system}.csv",
                "--out",
                "up.csv",
            )
            == 0
        )
        uploaded = {who: [float(score) for score in row] for who, row in people(tmp_path / "up.csv").items()}
        assert uploaded == {login(n): scores[n] for n in CLASS}
