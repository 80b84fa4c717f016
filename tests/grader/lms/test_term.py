"""A term: 120 students, three assignments, Canvas, Moodle and Gradescope, in and out, compared row by row.

The layouts are those of the vendors' code, as `SYSTEMS` cites it. A module says whose work it is, so that a result that
is credited to another student shows.
"""

import csv
import json
import re
import unicodedata
import zipfile
from datetime import datetime, timedelta

import pytest

from tam570_grader import cli
from tam570_grader.results.records import FORMAT
from tam570_grader.results.store import RESULT_FIELDS, ResultStore

SLUGS = "hw03_angular_momentum_rate", "hw08_axis_angle", "hw09_book"
GROUPED, DAY = SLUGS[0], timedelta(days=1)
DUE = {slug: datetime(2026, 9, 14, 23, 59) + 7 * n * DAY for n, slug in enumerate(SLUGS)}
ODD = [  # last name, first name, login: accents, signs, two of one name, a login that is a number or an assignment
    ("García Núñez", "José", "garcia"),
    ("O'Brien", "Pat", "obrien"),
    ("d’Artagnan", "Zoë", "zoe@x.edu"),
    ("Ærøskøbing", "Bjørn", "hw7"),
    ("Lee", "Ann", "ann"),
    ("Lee", "Ann", "1007"),  # the number of another student
    ("李", "小龙", "lixl"),
    ("van der Berg-Smith Jr.", "Mary Ann", "juan@pol.una.py"),
    (unicodedata.normalize("NFD", "Müller"), unicodedata.normalize("NFD", "Jürgen"), "jm-1"),
]
NAMES = [*ODD, *((f"Last{n}x", f"First{n}", f"net{n:03}") for n in range(120 - len(ODD)))]
CLASS = range(len(NAMES))
NUMBER = {n: str(1000 + n) for n in CLASS}
ABSENT = {slug: {n for n in CLASS if n % 17 == 3 + k} for k, slug in enumerate(SLUGS)}
EXCUSED = {(n, SLUGS[1]) for n in CLASS if n % 23 == 5}
EXTENSION = {n: 2 for n in CLASS if n % 20 == 8}  # days, in hw08
WRONG_NAMES = ("{slug}.py", "my {slug} final (2).PY", "solution.py", "{slug}.py.txt", "{short}.py")
DROPPED = 1


def team(n):
    """Students 20 to 49 are ten groups in the first assignment."""
    return f"Team {(n - 20) // 3}" if 20 <= n < 50 else ""


def login(n):
    return NAMES[n][2]


def author(n, slug):
    """Whose file a student is graded by: in a group, the first member's."""
    return n - (n - 20) % 3 if slug == GROUPED and team(n) else n


def days_late(n, slug):
    """Students 8, 18, ... are late, some of them by more days."""
    return (author(n, slug) // 10) % 4 + 0.5 if author(n, slug) % 10 == 8 else 0


def came(n, slug):
    late = days_late(n, slug)
    return DUE[slug] + (late * DAY if late else -timedelta(hours=n % 50 + 1))


def raw(n, slug):
    return round(2 + author(n, slug) / 20 + SLUGS.index(slug) / 8, 3)


def hands_in(n, slug):
    return author(n, slug) == n and n not in ABSENT[slug]


def is_here(n, slug):
    return author(n, slug) not in ABSENT[slug]


def settled(n, slug):
    """The score in the end, by the terms of course.toml; None for who is excused."""
    if (n, slug) in EXCUSED:
        return None
    if not is_here(n, slug):
        return 0.0
    late = days_late(n, slug) - (EXTENSION.get(n, 0) if slug == SLUGS[1] else 0)
    return round(raw(n, slug) * (1 - min(0.5, 0.1 * max(0, -(-late // 1)))), 6)


def dropped(n):
    """The assignments that are not counted: excused, and the lowest of the others."""
    counting = [slug for slug in SLUGS if settled(n, slug) is not None]
    lowest = sorted(counting, key=lambda slug: settled(n, slug))[:DROPPED]
    return {*lowest, *(slug for slug in SLUGS if slug not in counting)}


def file_name(n, slug):
    return WRONG_NAMES[n % len(WRONG_NAMES)].format(slug=slug, short=slug[:4])


def letters(name):
    """`sanitize_file_name` of instructure/canvas-lms, lib/content_zipper.rb."""
    return "".join(c for c in name.lower() if re.match(r"[\w]", c))


def canvas_zip(n, slug):
    who = letters(team(n) if slug == GROUPED and team(n) else f"{NAMES[n][0]}, {NAMES[n][1]}")
    late = "LATE_" if days_late(n, slug) else ""
    return f"{who}_{late}{NUMBER[n]}_{5000 + n}_{file_name(n, slug)}"


def moodle_zip(n, slug):
    """`get_student_prefix` of moodle/moodle, mod/assign/classes/downloader.php; a group's number is its own."""
    group = team(n) if slug == GROUPED else ""
    who = f"{group}_{1000 + n + 1}" if group else f"{NAMES[n][1]} {NAMES[n][0]}_{NUMBER[n]}"
    return f"{who}_assignsubmission_file/{file_name(n, slug)}"


def gradescope_zip(n, slug):
    return f"assignment_1_export/submission_{5000 + n}/{file_name(n, slug)}"


ZIPS = {"canvas": canvas_zip, "moodle": moodle_zip, "gradescope": gradescope_zip}


def submission_metadata(slug):
    table = {}
    for n in filter(lambda n: hands_in(n, slug), CLASS):
        members = [m for m in CLASS if author(m, slug) == n]
        people = [
            {":name": f"{NAMES[m][1]} {NAMES[m][0]}", ":sid": login(m), ":email": f"{login(m)}@x.edu"} for m in members
        ]
        table[f"submission_{5000 + n}"] = {":submitters": people, ":created_at": f"{came(n, slug)} Z"}
    return json.dumps(table)


def canvas_gradebook():
    """`csv_data` of lib/gradebook_exporter.rb."""
    heading = [
        "Student",
        "ID",
        "SIS User ID",
        "SIS Login ID",
        "Section",
        *(f"{s} ({70 + k})" for k, s in enumerate(SLUGS)),
    ]
    rows = [[f"{NAMES[n][0]}, {NAMES[n][1]}", NUMBER[n], f"S{n}", login(n), "570", "", "", ""] for n in CLASS]
    test = ["Student, Test", "99", "", "f00ba4", "570", "", "", ""]
    return [heading, ["    Points Possible", "", "", "", "", "10", "10", "10"], *reversed(rows), test]


def moodle_worksheet(slug):
    """mod/assign/gradingtable.php."""
    heading = ["Identifier", "Full name", "Username", "Status", "Group", "Grade", "Last modified (submission)"]

    def when(n):
        return f"{came(n, slug):%A, %d %B %Y, %I:%M %p}" if is_here(n, slug) else "-"

    return [heading] + [
        [f"Participant {NUMBER[n]}", f"{NAMES[n][1]} {NAMES[n][0]}", login(n), "", team(n), "", when(n)] for n in CLASS
    ]


COURSE = f"""
[late]
off_a_day = 0.1
most_off = 0.5
zone = "UTC"
[hw03]
due = {DUE[SLUGS[0]].isoformat()}
[hw08]
due = {DUE[SLUGS[1]].isoformat()}
[hw08.extension]
{chr(10).join(f'"{login(n)}" = {days}' for n, days in EXTENSION.items())}
[hw09]
due = {DUE[SLUGS[2]].isoformat()}
"""


@pytest.fixture
def desk(tmp_path, monkeypatch, course, capsys):
    """`desk(*command)` -> exit code and what was said, in an empty folder with a course.toml that is trusted."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("TAM570_COURSE", str(tmp_path))
    monkeypatch.setenv("TAM570_HOME", str(tmp_path / "home"))
    (tmp_path / "course.toml").write_text(COURSE)

    def run(*command):
        code = cli.main([*command])
        return code, "".join(capsys.readouterr())

    return run


def write(path, rows):
    with open(path, "w", newline="", encoding="utf-8-sig") as file:
        csv.writer(file).writerows(rows)


def table(path):
    with open(path, newline="", encoding="utf-8-sig") as file:
        return list(csv.reader(file))


def grade(folder):
    """Results as `grade` writes them, by what the files say; of who handed in nothing as with --roster."""
    store = ResultStore(folder / "results")
    files = {path.parts[-3:-1]: int(path.read_text().split()[-1]) for path in (folder / "submitted").glob("*/*/*.py")}
    for n in CLASS:
        for slug in SLUGS:
            written_by = files.get((login(n), slug))
            score = 0.0 if written_by is None else round(2 + written_by / 20 + SLUGS.index(slug) / 8, 3)
            status = "missing" if written_by is None else "graded"
            fields = {"student": login(n), "assignment": slug, "status": status, "score": score, "max_score": 10.0}
            store.add({**dict.fromkeys(RESULT_FIELDS, 0), "format": FORMAT, **fields, "checks": [], "seed": 1})
    store.close()
    return files


@pytest.mark.parametrize("system", ZIPS)
def test_a_class_of_120_in_and_out(desk, tmp_path, system):
    write("canvas.csv", canvas_gradebook())
    write("groups.csv", [("group", "login"), *((team(n), login(n)) for n in CLASS if team(n))])
    write("people.csv", [("Name", "SID", "Email"), *((f"{NAMES[n][1]} {NAMES[n][0]}", login(n), "") for n in CLASS)])
    for slug in SLUGS:
        write("moodle.csv", moodle_worksheet(slug))
        with zipfile.ZipFile("download.zip", "w") as archive:
            for n in filter(lambda n: hands_in(n, slug), CLASS):
                archive.writestr(ZIPS[system](n, slug), f"# the work of {n}")
            if system == "gradescope":
                archive.writestr("assignment_1_export/submission_metadata.yml", submission_metadata(slug))
        roster = {"gradescope": "people"}.get(system, system)
        groups = ["--groups", "groups.csv"] * (system == "canvas" and slug == GROUPED)
        command = ["collect", "download.zip", "--from", system, "--roster", f"{roster}.csv", *groups]
        assert desk(*command, "--assignment", slug)[0] == 0
    expected = {(login(n), slug): author(n, slug) for n in CLASS for slug in SLUGS if is_here(n, slug)}
    assert grade(tmp_path) == expected  # nobody is lost, nobody credited for another

    rows = [(login(n), slug, "excused", 1, "ill") for n, slug in sorted(EXCUSED)]
    if system == "canvas":  # whose zip file tells who is late, and not when
        late = [(n, slug) for n in CLASS for slug in SLUGS if is_here(n, slug) and days_late(n, slug)]
        rows += [(login(n), slug, "late", days_late(n, slug), "") for n, slug in late]
    write("by hand.csv", [("student", "assignment", "item", "points", "comment"), *rows])
    code, said = desk("points", "results", "by hand.csv", "--collected", "collected.csv")
    assert code == 0, said
    scores = {(row[0], row[1]): row[3] for row in table("results/grades.csv")[1:]}
    expected = {(login(n), slug): settled(n, slug) for n in CLASS for slug in SLUGS}
    assert scores == {key: "EX" if score is None else str(score) for key, score in expected.items()}

    lms = "lms", "results/grades.csv", "--ungraded", "zero", "--out", "up.csv"
    assert desk(*lms, "--to", "canvas", "--roster", "canvas.csv")[0] == 0
    back = table("up.csv")
    before = canvas_gradebook()
    assert [row[:5] for row in back] == [row[:5] for row in before[:-1]]  # the test student is nobody
    assert [row[5:] for row in back[2:]] == [[scores[row[3], slug] for slug in SLUGS] for row in before[2:-1]]
    code, said = desk(*lms, "--to", "moodle", "--roster", "moodle.csv")
    rows = {row[0]: row[1:] for row in table("up.csv")[1:]}
    assert rows == {login(n): [scores[login(n), slug].replace("EX", "") for slug in SLUGS] for n in CLASS}

    write("term.csv", [("student", "assignment", "item", "points"), ("*", "*", "drop lowest", DROPPED)])
    assert desk("points", "results", "term.csv")[0] == 0
    counting = {row[0:2] for row in map(tuple, table("results/grades.csv")[1:]) if row[3] != "EX"}
    assert counting == {(login(n), slug) for n in CLASS for slug in SLUGS if slug not in dropped(n)}
    assert desk("report", "results", "--roster", "canvas.csv", "--collected", "collected.csv")[0] == 0
    page = (tmp_path / "results" / "report.html").read_text()
    sums = dict(re.findall(r"<tr><th scope=row>([^<]*)</th>.*<td>([\d.]*)</td></tr>", page))
    assert len(sums) == len(CLASS)
    for n in CLASS:
        total = sum(settled(n, slug) for slug in SLUGS if slug not in dropped(n))
        assert abs(float(sums[login(n)]) - total) <= 0.0051, n
    if system != "canvas":
        late = sum(is_here(n, SLUGS[2]) and days_late(n, SLUGS[2]) > 0 for n in CLASS)
        cells = re.search(r'<th scope="row">hw09</th>(.*?)<svg', page)[1]
        assert re.findall(r'class="n">(\d+)<', cells)[-1] == str(late)


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_left_out_is_named_and_the_code_is_1(desk, system):
    write("canvas.csv", canvas_gradebook())
    write("moodle.csv", moodle_worksheet(SLUGS[1]))
    rows = [(login(n), SLUGS[1], 9, 10) for n in CLASS if n != 40]
    write("grades.csv", [("student", "assignment", "score", "max_score"), *rows, ("ghost", SLUGS[1], 9, 10)])
    code, said = desk("lms", "grades.csv", "--to", system, "--roster", f"{system}.csv", "--out", "up.csv")
    assert code == 1 and said.count("warning: ") == 2
    assert "ghost has scores and is on no row of the roster" in said and "(net031) has no score in hw08" in said
