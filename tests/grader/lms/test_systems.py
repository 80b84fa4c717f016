"""Each system as its vendor's code writes it, with a class of odd names: nobody lost, nobody credited for another."""

import csv
import io
import json
import tracemalloc
import zipfile

import pytest

from tam570_grader import cli
from tam570_grader.course.course_toml import COLUMNS
from tam570_grader.lms.systems import SYSTEMS
from tam570_grader.results.tables import cell, name_in

SLUG, OTHER = "hw08_axis_angle", "hw07_double_pendulum"
# login, number, last and first name, group
CLASS = [
    ("obrien", "11", "O'Brien", "Pat", "Team 7"),
    ("garcia", "7", "García Núñez", "José", "Team 7"),
    ("17", "12", "de la Cruz", "Ana", "Team 8"),
    ("ann", "17", "Lee", "Ann", "Team 8"),
    ("ann2", "18", "Lee", "Ann", "Team 8"),
    ("hw7", "19", "Zoë", "Ærøskøbing", "Team 9"),
    ("juan@pol.una.py", "20", "Pérez", "Juan", "Team 9"),
]
CANVAS_LAYOUTS = [  # gradebook_exporter.rb, csv_data: with and without the SIS ids, with more ids, with split names
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Integration ID", "Root Account", "Section"),
    ("LastName", "FirstName", "ID", "SIS Login ID", "Section"),
]


def packed(files):
    data = io.BytesIO()
    with zipfile.ZipFile(data, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return data.getvalue()


def words(name):
    """What `sanitize_file_name` of Canvas's content_zipper.rb leaves of a name."""
    return "".join(c for c in name.lower() if c.isalnum() or c == "_")


def canvas_name(n, order=500):
    _, number, last, first, _ = CLASS[n]
    return f"{words(f'{last}, {first}')}_{number}_{order}"


def moodle_name(n):
    _, number, last, first, _ = CLASS[n]
    return f"{first} {last}".replace("'", "") + f"_{number}_assignsubmission_file"


def gradebook(layout, column="HW 8: Rotations (810001)", cells=None):
    """Canvas's export, with the rows that are not students'."""
    cells = cells or {}
    own = {"SIS User ID": "S{}", "Integration ID": "I{}", "Root Account": "x.edu", "Section": "570"}
    rows = [[*layout, "Notes", column, "Final Score"], ["", *[""] * len(layout), "Manual Posting", ""]]
    rows.append(["    Points Possible", *[""] * len(layout), "10", "(read only)"])
    for login, number, last, first, _ in [*CLASS, ("f00ba4", "99", "Student", "Test", "")]:
        told = {
            "Student": f"{last}, {first}",
            "LastName": last,
            "FirstName": first,
            "ID": number,
            "SIS Login ID": login,
        }
        told |= {key: text.format(number) for key, text in own.items()}
        rows.append([*(told[key] for key in layout), "", cells.get(login, ""), ""])
    return rows


def worksheet(when="Monday, 14 September 2026, 11:59 PM", *, groups=False):
    """Moodle's, by gradingtable.php: Identifier, Full name, Email address, Status, Group, Grade, times."""
    heading = [
        "Identifier",
        "Full name",
        "Username",
        "Status",
        *["Group"] * groups,
        "Grade",
        "Last modified (submission)",
    ]
    rows = [
        [f"Participant {number}", f"{first} {last}", login, "Submitted", *[group] * groups, "", when]
        for login, number, last, first, group in CLASS
    ]
    return [heading, *rows]


@pytest.fixture
def desk(tmp_path, monkeypatch, course, capsys):
    """`desk(*command)` -> exit code and what was said; `desk.write(name, rows or bytes)`."""
    monkeypatch.chdir(tmp_path)

    def run(*command):
        code = cli.main(["--root", str(course), *command])
        return code, "".join(capsys.readouterr())

    def write(name, content):
        if isinstance(content, bytes):
            (tmp_path / name).write_bytes(content)
        else:
            with open(tmp_path / name, "w", newline="", encoding="utf-8-sig") as file:
                csv.writer(file).writerows(content)

    def read(name):
        with open(tmp_path / name, newline="", encoding="utf-8-sig") as file:
            return list(csv.reader(file))

    run.write, run.read, run.place = write, read, tmp_path
    run.collected = lambda: {
        path.parts[-3]: path.read_text() for path in (tmp_path / "submitted").glob(f"*/{SLUG}/*.py")
    }
    return run


def of_everybody(name):
    return {login: f"# of {login}" for login, *_ in CLASS}, {
        f"{name(n)}": f"# of {CLASS[n][0]}" for n in range(len(CLASS))
    }


@pytest.mark.parametrize("layout", CANVAS_LAYOUTS)
def test_a_class_from_canvas_to_canvas(desk, layout):
    expected, files = of_everybody(canvas_name)
    desk.write("a.zip", packed({f"{name}_hw08.py": text for name, text in files.items()}))
    desk.write("gradebook.csv", gradebook(layout, cells={"obrien": "EX"}))
    code, said = desk("collect", "a.zip", "--from", "canvas", "--roster", "gradebook.csv")
    assert (code, desk.collected()) == (0, expected), said
    scores = [(login, SLUG, "graded", n + 0.5, 10.0) for n, (login, *_) in enumerate(CLASS)]
    desk.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *scores])
    code, said = desk("lms", "grades.csv", "--to", "canvas", "--roster", "gradebook.csv", "--out", "up.csv")
    assert code == 2 and "HW 8: Rotations (810001)" in said and not (desk.place / "up.csv").exists()
    for text in ('canvas = "HW 8: Rotations (810001)"', "canvas = 810001", 'canvas = "HW 8: Rotations"'):
        (desk.place / "course.toml").write_text(f"[hw08]\n{text}\n")
        lms = ["lms", "grades.csv", "--to", "canvas", "--roster", "gradebook.csv", "--out", "up.csv"]
        assert cli.main(["--root", str(desk.place), *lms]) == 0
        heading, possible, *rows = desk.read("up.csv")
        before = {row[list(layout).index("ID")]: row[: len(layout)] for row in gradebook(layout)[3:-1]}
        assert heading == [*layout, "HW 8: Rotations (810001)"] and possible[-1] == "10"
        after = {row[list(layout).index("ID")]: row for row in rows}
        assert {key: row[:-1] for key, row in after.items()} == before  # the test student is nobody
        points = [after[number][-1] for _, number, *_ in CLASS]
        assert points == ["EX", *(f"{n + 0.5}" for n in range(1, len(CLASS)))]


def test_a_score_that_was_changed_in_the_gradebook_stays_and_is_named(desk):
    desk.write("gradebook.csv", gradebook(CANVAS_LAYOUTS[0], f"{SLUG} (5)", {"ann": "9", "ann2": "4.00", "hw7": "N/A"}))
    rows = [(login, SLUG, "graded", 4.0, 12.0) for login, *_ in CLASS]
    desk.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *rows])
    lms = ["lms", "grades.csv", "--to", "canvas", "--roster", "gradebook.csv", "--out", "up.csv"]
    code, said = desk(*lms)
    points = {row[3]: row[-1] for row in desk.read("up.csv")[2:]}
    assert code == 1 and points["ann"] == "9" and points["hw7"] == "N/A" and points["obrien"] == "4.0"
    assert "Lee, Ann keeps 9" in said and "has 10 points possible" in said
    desk(*lms, "--overwrite")
    points = {row[3]: row[-1] for row in desk.read("up.csv")[2:]}
    assert points["ann"] == "4.0" and points["hw7"] == "N/A"


@pytest.mark.parametrize("form", ["{}/hw08.py", "{}_/hw08.py", "{}_hw08.py"])  # downloader.php, and before 4.1
def test_a_class_from_moodle(desk, form):
    expected, files = of_everybody(moodle_name)
    desk.write("a.zip", packed({form.format(name): text for name, text in files.items()}))
    desk.write("worksheet.csv", worksheet())
    code, said = desk("collect", "a.zip", "--from", "moodle", "--roster", "worksheet.csv")
    assert (code, desk.collected()) == (0, expected), said


LATE = "[late]\noff_a_day = 0.5\n[hw08]\ndue = 2026-09-14T23:59:00\n"
LOG = [["Time", "User full name", "Affected user", "Event context", "Component", "Event name"]] + [
    [f"15/09/26, 10:0{k}:00", "José García Núñez", "-", "Assignment: HW 8", "Assignment", event]
    for k, event in enumerate(("A submission has been submitted.", "The status of the submission has been viewed."))
]


@pytest.mark.parametrize("told", ["nothing", "worksheet", "late worksheet", "log"])
def test_moodles_zip_tells_no_time(desk, told, solution_text):
    """Every file has the date of the download: a worksheet or a log knows better; without one nobody is late."""
    files = {f"{moodle_name(n)}/hw08.py": solution_text(SLUG) for n in range(2)}
    desk.write("a.zip", packed(files))
    desk.write("log.csv", LOG)
    desk.write("on_time.csv", worksheet("Monday, 14 September 2026, 11:58 PM" if told != "nothing" else "-"))
    desk.write("late.csv", worksheet("Tuesday, 15 September 2026, 10:00 AM"))
    desk.write("plain.csv", [row[:3] for row in worksheet()])
    roster = "plain.csv" if told == "log" else "late.csv" if told == "late worksheet" else "on_time.csv"
    more = ["--times", "log.csv"] if told == "log" else []
    assert desk("collect", "a.zip", "--from", "moodle", "--roster", roster, *more)[0] == 0
    (desk.place / "course.toml").write_text(LATE)
    at = ["--root", str(desk.place)]
    assert cli.main([*at, "grade", "submitted", "--out", "results", "--seed", "1"]) == 0
    assert cli.main([*at, "points", "results", "--collected", "collected.csv"]) == 0
    scores = {row[0]: float(row[3]) for row in desk.read("results/grades.csv")[1:]}
    late = {"late worksheet": {"garcia", "obrien"}, "log": {"garcia"}}.get(told, set())
    assert scores == {who: 5.0 if who in late else 10.0 for who in ("garcia", "obrien")}


TEAMS = [("group", "login"), *((group, login) for login, *_, group in CLASS)]
EVERY_TEAM = {login: f"# {group}" for login, *_, group in CLASS}


@pytest.mark.parametrize("how", ["moodle, worksheet", "moodle, table", "canvas, table"])
def test_everybody_of_a_group_gets_its_work(desk, how):
    """Moodle's folders have the group's number, Canvas's files the number of one member."""
    names = {"Team 7": "Team 7_7", "Team 8": "Team 8_17", "Team 9": "Team 9_900"}
    files = {f"{name}_assignsubmission_file/hw08.py": f"# {team}" for team, name in names.items()}
    if how.startswith("canvas"):
        members = {"Team 7": "7", "Team 8": "17", "Team 9": "20"}
        files = {f"{words(team)}_{number}_500_hw08.py": f"# {team}" for team, number in members.items()}
    desk.write("a.zip", packed(files))
    desk.write("groups.csv", TEAMS)
    system = how.split(",")[0]
    desk.write(
        "roster.csv",
        worksheet(groups=how.endswith("worksheet")) if system == "moodle" else gradebook(CANVAS_LAYOUTS[0]),
    )
    collect = ["collect", "a.zip", "--from", system, "--roster", "roster.csv"]
    code, said = desk(*collect, *(["--groups", "groups.csv"] if how.endswith("table") else []))
    assert (code, desk.collected()) == (0, EVERY_TEAM), said


@pytest.mark.parametrize("system", ["moodle", "canvas"])
def test_a_number_whose_name_disagrees_is_not_believed(desk, system):
    """Nobody told the groups: number 7 is somebody of another team."""
    names = {"moodle": "Team 8_7_assignsubmission_file/hw08.py", "canvas": "team8_7_500_hw08.py"}
    desk.write("a.zip", packed({names[system]: "# of team 8"}))
    desk.write("roster.csv", worksheet() if system == "moodle" else gradebook(CANVAS_LAYOUTS[0]))
    code, said = desk("collect", "a.zip", "--from", system, "--roster", "roster.csv")
    assert code == 1 and desk.collected() == {} and "--groups" in said


def test_a_canvas_group_with_a_number_of_nobody_in_it_is_not_believed(desk):
    desk.write("a.zip", packed({"team8_7_500_hw08.py": "# of team 8"}))
    desk.write("roster.csv", gradebook(CANVAS_LAYOUTS[0]))
    desk.write("groups.csv", TEAMS)
    code, _ = desk("collect", "a.zip", "--from", "canvas", "--roster", "roster.csv", "--groups", "groups.csv")
    assert code == 1 and desk.collected() == {}


def test_a_stranger_of_the_same_name_takes_nobodys_place(desk):
    people = [{":name": "Ann Lee", ":email": "ann@else.org"}, {":name": "Ann Lee", ":email": "ann@x.edu", ":sid": "A1"}]
    table = {f"submission_{n}": {":submitters": [who], ":created_at": ""} for n, who in enumerate(people)}
    files = {
        "submission_metadata.yml": json.dumps(table),
        "submission_0/hw08.py": "# stranger",
        "submission_1/hw08.py": "# Ann",
    }
    desk.write("a.zip", packed(files))
    desk.write("roster.csv", [("First Name", "Last Name", "SID", "Email"), ("Ann", "Lee", "A1", "ann@x.edu")])
    code, said = desk("collect", "a.zip", "--from", "gradescope", "--roster", "roster.csv")
    assert code == 1 and desk.collected()["A1"] == "# Ann" and "on no row of the roster" in said


def test_a_login_is_no_number(desk):
    """Somebody's login is 17, and user 17 is on no row."""
    desk.write("roster.csv", [row for row in gradebook(CANVAS_LAYOUTS[0]) if row[1] != "17"])
    desk.write("a.zip", packed({"smithal_17_5_hw08.py": "# a stranger", "delacruzana_12_6_hw08.py": "# Ana"}))
    code, _ = desk("collect", "a.zip", "--from", "canvas", "--roster", "roster.csv")
    assert code == 1 and desk.collected() == {"17": "# Ana"}


def test_a_score_goes_to_the_login_not_to_the_number(desk):
    desk.write("roster.csv", gradebook(CANVAS_LAYOUTS[0], f"{SLUG} (5)"))
    desk.write("grades.csv", [("student", "assignment", "score", "max_score"), ("17", SLUG, 9.0, 10.0)])
    desk("lms", "grades.csv", "--to", "canvas", "--roster", "roster.csv", "--out", "up.csv")
    assert {row[3]: row[-1] for row in desk.read("up.csv")[2:] if row[-1]} == {"17": "9.0"}


def test_a_download_is_of_one_assignment(desk):
    """hw08 handed in again in the dropbox of hw07 replaces nothing; what a download replaces is named."""
    desk.write("roster.csv", gradebook(CANVAS_LAYOUTS[0]))
    collect = ["--from", "canvas", "--roster", "roster.csv"]
    desk.write("a.zip", packed({f"{canvas_name(n)}_hw08.py": f"# {n}" for n in range(4)}))
    assert desk("collect", "a.zip", *collect)[0] == 0
    before = desk.collected()
    files = {f"{canvas_name(n, 600)}_hw07.py": f"# {n}" for n in range(3)}
    desk.write("b.zip", packed({**files, f"{canvas_name(3, 600)}_hw08.py": "# again, and late"}))
    code, said = desk("collect", "b.zip", *collect)
    assert code == 1 and desk.collected() == before and "is named after hw08" in said
    assert not (desk.place / "submitted" / "ann" / OTHER).exists()
    desk.write("c.zip", packed({f"{canvas_name(3, 700)}_hw08.py": "# newer"}))
    code, said = desk("collect", "c.zip", *collect)
    assert code == 0 and "is replaced by" in said and desk.collected() == {**before, "ann": "# newer"}


@pytest.mark.parametrize("heading", ["Vorname;Nachname;Anmeldename", "Étudiant,Identifiant", "a,b"])
def test_a_table_with_unknown_headings_is_refused(desk, heading):
    desk.write("a.zip", packed({"leeann_17_5_hw08.py": "# x"}))
    (desk.place / "roster.csv").write_text(f"{heading}\nAnn;Lee;ann\n")
    code, said = desk("collect", "a.zip", "--from", "canvas", "--roster", "roster.csv")
    assert code == 2 and "sis login id" in said


# Hostile downloads


def test_a_student_fills_no_memory(desk):
    bomb = packed({f"{n}/hw08.py": bytes(10 * 2**20) for n in range(2)})
    desk.write(
        "a.zip", packed({f"leeann_17_{n}_hw08.zip": bomb for n in range(60)} | {"delacruzana_12_6_hw08.py": "# Ana"})
    )
    tracemalloc.start()
    code, said = desk("collect", "a.zip", "--from", "canvas")
    most = tracemalloc.get_traced_memory()[1]
    tracemalloc.stop()
    assert code == 1 and most < 60 * 2**20 and said.count("warning") < 20


@pytest.mark.parametrize(
    "name",
    [
        "leeann_17_5_" + "\x1b" * 40_000 + ".py",
        "leeann_" + "1" * 4400 + "_5_hw08.py",
        "leeann_17_" + "9" * 4400 + "_hw08.py",
    ],
    ids=["control characters", "user", "attachment"],
)
def test_a_long_name_spoils_no_table(desk, name):
    desk.write("a.zip", packed({name: "# x", "delacruzana_12_6_hw08.py": "# Ana"}))
    for _ in range(2):
        code, said = desk("collect", "a.zip", "--from", "canvas")
        assert code == 1 and desk.collected()["12"] == "# Ana" and len(said) < 20_000


def test_a_zip_file_of_many_names_is_refused_unread(desk):
    many = packed({f"{n:06}": "" for n in range(30_000)})
    desk.write("a.zip", packed({"leeann_17_5_hw08.zip": many, "delacruzana_12_6_hw08.py": "# Ana"}))
    code, said = desk("collect", "a.zip", "--from", "canvas")
    assert code == 1 and "more than 1000 files" in said and desk.collected() == {"12": "# Ana"}


@pytest.mark.parametrize("text", ["a;=1+1", "x\t@sum", "'=1;'-2", "a;b;;+c", "ok\n=2"])
def test_no_cell_is_a_formula_wherever_a_spreadsheet_splits(text):
    for piece in cell(text).replace("\t", ";").replace("\n", ";").split(";"):
        assert not piece.startswith(("=", "+", "-", "@"))
    assert name_in(cell(text)) == text


# The other systems


def test_blackboard_and_back(desk):
    rows = [(f"Last{n}", f"First{n}", login, number) for n, (login, number, *_) in enumerate(CLASS)]
    heading = ("Last Name", "First Name", "Username", "Student ID", f"{SLUG} [Total Pts: 10 Score] |664617")
    desk.write("gradebook.csv", [heading, *((*row, "") for row in rows)])
    files = {f"HW 8_{login}_attempt_2026-09-14-23-58-00_hw08.py": f"# of {login}" for login, *_ in CLASS}
    files |= {f"HW 8_{login}_attempt_2026-09-14-23-58-00.txt": "Name: x" for login, *_ in CLASS}
    desk.write("a.zip", packed(files))
    code, said = desk("collect", "a.zip", "--from", "blackboard", "--roster", "gradebook.csv")
    assert (code, desk.collected()) == (0, {login: f"# of {login}" for login, *_ in CLASS}), said
    assert desk.read("collected.csv")[1][4] == "2026-09-14 23:58:00"
    scores = [(login, SLUG, "graded", n, 10) for n, (login, *_) in enumerate(CLASS)]
    desk.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *scores])
    code, said = desk("lms", "grades.csv", "--to", "blackboard", "--roster", "gradebook.csv", "--out", "up.csv")
    assert code == 0, said
    assert desk.read("up.csv") == [[*heading], *([*row, str(n)] for n, row in enumerate(rows))]


def test_brightspace_and_back(desk):
    names = [f"{first} {last}" for _, _, last, first, _ in CLASS if (last, first) != ("Lee", "Ann")]
    logins = [login for login, _, last, first, _ in CLASS if (last, first) != ("Lee", "Ann")]
    heading = (
        "OrgDefinedId",
        "Username",
        "Last Name",
        "First Name",
        "HW 8 Points Grade <Numeric MaxPoints:10>",
        "End-of-Line Indicator",
    )
    people = [
        (f"#{n}", f"#{login}", *name.split(" ", 1)[::-1], "", "#")
        for n, (login, name) in enumerate(zip(logins, names, strict=True))
    ]
    desk.write("gradebook.csv", [heading, *people])
    files = {f"123-{n} - {name} - Sep 14, 2026 1158 PM/hw08.py": f"# {n}" for n, name in enumerate(names)}
    desk.write("a.zip", packed({**files, "index.html": ""}))
    code, _ = desk("collect", "a.zip", "--from", "brightspace", "--roster", "gradebook.csv")
    assert desk.collected() == {login: f"# {n}" for n, login in enumerate(logins)} and code == 1  # index.html
    scores = [(login, SLUG, "graded", n, 10) for n, login in enumerate(logins)]
    desk.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *scores])
    (desk.place / "course.toml").write_text('[hw08]\nbrightspace = "HW 8"\n')
    lms = ["lms", "grades.csv", "--to", "brightspace", "--roster", "gradebook.csv", "--out", "up.csv"]
    assert cli.main(["--root", str(desk.place), *lms]) == 0
    first, *rows = desk.read("up.csv")
    assert first == [*heading[:2], heading[4], heading[5]] and rows[2] == [people[2][0], people[2][1], "2", "#"]


def test_github_classroom(desk):
    for n, user in enumerate(("octo-cat", "hubot", "mona")):
        folder = desk.place / "repositories" / f"hw08-{user}"
        (folder / ".git").mkdir(parents=True)
        (folder / ".git" / "config.py").write_text("# no work")
        (folder / f"{SLUG}.py").write_text(f"# {n}")
    logins = zip(("ann", "bo", "cy"), ("octo-cat", "hubot", "mona"), strict=True)
    desk.write(
        "roster.csv", [("identifier", "github_username", "github_id", "name"), *((a, b, "", "") for a, b in logins)]
    )
    code, said = desk("collect", "repositories", "--from", "github", "--roster", "roster.csv")
    assert (code, desk.collected()) == (0, {"ann": "# 0", "bo": "# 1", "cy": "# 2"}), said


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_a_system_lacks_is_a_sentence(desk, name):
    system = SYSTEMS[name]
    desk.write(
        "grades.csv", [("student", "assignment", "status", "score", "max_score"), ("ann", SLUG, "graded", 9, 10)]
    )
    desk.write("collected.csv", [("student", "name", "assignment", "file", "when", "late", "from", "note")])
    if system.table is None:
        with pytest.raises(SystemExit):
            desk("lms", "grades.csv", "--to", name)
    else:
        code, said = desk("lms", "grades.csv", "--to", name)
        assert code == 0 and "9" in said
        pages = ["--pages", "p.zip", "--collected", "collected.csv"]
        assert desk("lms", "grades.csv", "--to", name, *pages)[0] == 2
    assert (name in COLUMNS) == bool(system.table and system.table.must_match)


def test_drawings_and_words_lie_beside_the_work(desk):
    """As `tam570 handin` packs them; alone they are no work."""
    files = {f"{SLUG}.py": "# Ann", "my plot.png": "png", "answers.md": "words", "../x.png": "no"}
    desk.write(
        "a.zip", packed({"leeann_17_5_hw08_axis_angle_handin.zip": packed(files), "leeann_18_6_hw08.pdf": "%PDF"})
    )
    code, said = desk("collect", "a.zip", "--from", "canvas")
    there = {path.name: path.read_text() for path in (desk.place / "submitted" / "17" / SLUG).iterdir()}
    assert there == {f"{SLUG}.py": "# Ann", "beside-my_plot.png": "png", "beside-answers.md": "words"}
    assert code == 1 and not (desk.place / "submitted" / "18").exists() and "hw08.pdf of 18 is not collected" in said


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_excused_is_so_in_the_words_of_the_system(desk, system):
    desk.write("canvas.csv", gradebook(CANVAS_LAYOUTS[0], f"{SLUG} (5)"))
    desk.write("moodle.csv", worksheet())
    rows = [(login, SLUG, "graded", "EX" if login == "ann" else 9, 10) for login, *_ in CLASS]
    desk.write("grades.csv", [("student", "assignment", "status", "score", "max_score"), *rows])
    for roster in ([], ["--roster", f"{system}.csv"]):
        code, said = desk("lms", "grades.csv", "--to", system, *roster, "--out", "up.csv")
        told = {row[0 if system == "moodle" else 3]: row[-1] for row in desk.read("up.csv")}
        assert code == 0 and told["ann"] == ("EX" if system == "canvas" else "") and told["ann2"] == "9", said
