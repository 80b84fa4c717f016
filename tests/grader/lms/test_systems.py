"""Each system as its vendor's code writes it, with a class of odd names: nobody lost, nobody credited for another."""

import json
import tracemalloc

import pytest
from classes import HW08, packed

from tam570_grader.course.course_toml import COLUMNS
from tam570_grader.lms.systems import SYSTEMS

OTHER = "hw07_double_pendulum"
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
LOGINS = [login for login, *_ in CLASS]
CANVAS_LAYOUTS = [  # gradebook_exporter.rb, csv_data: with and without the SIS ids, with more ids, with split names
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Integration ID", "Root Account", "Section"),
    ("LastName", "FirstName", "ID", "SIS Login ID", "Section"),
]


def words(name):
    """What `sanitize_file_name` of Canvas's content_zipper.rb leaves of a name."""
    return "".join(c for c in name.lower() if c.isalnum() or c == "_")


def canvas_name(n, order=500):
    _, number, last, first, _ = CLASS[n]
    return f"{words(f'{last}, {first}')}_{number}_{order}"


def moodle_name(n):
    _, number, last, first, _ = CLASS[n]
    return f"{first} {last}".replace("'", "") + f"_{number}_assignsubmission_file"


def gradebook(layout=CANVAS_LAYOUTS[0], column="HW 8: Rotations (810001)", cells=None):
    """Canvas's export, with the rows that are not students'."""
    mine = {"SIS User ID": "S{}", "Integration ID": "I{}", "Root Account": "x.edu", "Section": "570"}
    rows = [[*layout, "Notes", column, "Final Score"], ["", *[""] * len(layout), "Manual Posting", ""]]
    rows.append(["    Points Possible", *[""] * len(layout), "10", "(read only)"])
    for login, number, last, first, _ in [*CLASS, ("f00ba4", "99", "Student", "Test", "")]:
        names = {"Student": f"{last}, {first}", "LastName": last, "FirstName": first}
        fields = {**names, "ID": number, "SIS Login ID": login} | {key: mine[key].format(number) for key in mine}
        rows.append([*(fields[key] for key in layout), "", (cells or {}).get(login, ""), ""])
    return rows


def worksheet(when="Monday, 14 September 2026, 11:59 PM", *, groups=False):
    """Moodle's, by gradingtable.php: Identifier, Full name, Email address, Status, Group, Grade, times."""
    heading = ["Identifier", "Full name", "Username", "Status", *["Group"] * groups, "Grade"]
    rows = [
        [f"Participant {number}", f"{first} {last}", login, "Submitted", *[group] * groups, "", when]
        for login, number, last, first, group in CLASS
    ]
    return [[*heading, "Last modified (submission)"], *rows]


def of_everybody(name):
    """What is to be collected, and the files of a download."""
    texts = {login: f"# of {login}" for login in LOGINS}
    return texts, {name(n): texts[login] for n, login in enumerate(LOGINS)}


@pytest.mark.parametrize("layout", CANVAS_LAYOUTS)
def test_a_class_from_canvas_to_canvas(desk, layout):
    expected, files = of_everybody(lambda n: f"{canvas_name(n)}_hw08.py")
    desk.write("a.zip", packed(files))
    desk.write("gradebook.csv", gradebook(layout, cells={"obrien": "EX"}))
    code, said = desk("collect", "a.zip", "--from", "canvas", "--roster", "gradebook.csv")
    assert (code, desk.collected) == (0, expected), said
    desk.write_grades({login: n + 0.5 for n, login in enumerate(LOGINS)})
    lms = ["lms", "grades.csv", "--to", "canvas", "--roster", "gradebook.csv", "--out", "up.csv"]
    code, said = desk(*lms)
    assert code == 2 and "HW 8: Rotations (810001)" in said and not (desk.place / "up.csv").exists()
    for text in ('canvas = "HW 8: Rotations (810001)"', "canvas = 810001", 'canvas = "HW 8: Rotations"'):
        desk.write("course.toml", f"[hw08]\n{text}\n")
        assert desk(*lms, root=desk.place)[0] == 0
        heading, possible, *rows = desk.read("up.csv")
        before = {row[list(layout).index("ID")]: row[: len(layout)] for row in gradebook(layout)[3:-1]}
        assert heading == [*layout, "HW 8: Rotations (810001)"] and possible[-1] == "10"
        after = {row[list(layout).index("ID")]: row for row in rows}
        assert {key: row[:-1] for key, row in after.items()} == before  # the test student is nobody
        points = [after[number][-1] for _, number, *_ in CLASS]
        assert points == ["EX", *(f"{n + 0.5}" for n in range(1, len(CLASS)))]


def test_a_score_that_was_changed_in_the_gradebook_stays_and_is_named(desk):
    desk.write("gradebook.csv", gradebook(column=f"{HW08} (5)", cells={"ann": "9", "ann2": "4.00", "hw7": "N/A"}))
    desk.write_grades(dict.fromkeys(LOGINS, 4.0))
    for more, code, ann in (([], 1, "9"), (["--overwrite"], 0, "4.0")):
        lms = ["lms", "grades.csv", "--to", "canvas", "--roster", "gradebook.csv", "--out", "up.csv"]
        actual, said = desk(*lms, *more)
        points = {row[3]: row[-1] for row in desk.read("up.csv")[2:]}
        assert actual == code and (points["ann"], points["hw7"], points["obrien"]) == (ann, "N/A", "4.0")
        assert ("Lee, Ann keeps 9" in said) == (code == 1)


@pytest.mark.parametrize("form", ["{}/hw08.py", "{}_/hw08.py", "{}_hw08.py"])  # downloader.php, and before 4.1
def test_a_class_from_moodle(desk, form):
    expected, files = of_everybody(lambda n: form.format(moodle_name(n)))
    desk.write("a.zip", packed(files))
    desk.write("worksheet.csv", worksheet())
    code, said = desk("collect", "a.zip", "--from", "moodle", "--roster", "worksheet.csv")
    assert (code, desk.collected) == (0, expected), said


LATE = "[late]\noff_a_day = 0.5\n[hw08]\ndue = 2026-09-14T23:59:00\n"
LOG = [["Time", "User full name", "Affected user", "Event context", "Component", "Event name"]] + [
    [f"15/09/26, 10:0{k}:00", "José García Núñez", "-", "Assignment: HW 8", "Assignment", event]
    for k, event in enumerate(("A submission has been submitted.", "The status of the submission has been viewed."))
]
ON_TIME, TOO_LATE = "Monday, 14 September 2026, 11:58 PM", "Tuesday, 15 September 2026, 10:00 AM"


@pytest.mark.parametrize(
    ("roster", "more", "late"),
    [
        (worksheet("-"), [], set()),
        (worksheet(ON_TIME), [], set()),
        (worksheet(TOO_LATE), [], {"garcia", "obrien"}),
        ([row[:3] for row in worksheet()], ["--times", "log.csv"], {"garcia"}),
    ],
    ids=["nothing", "worksheet", "late worksheet", "log"],
)
def test_moodles_zip_tells_no_time(desk, roster, more, late, solution_text):
    """Every file has the date of the download: a worksheet or a log knows better; without one nobody is late."""
    desk.write("a.zip", packed({f"{moodle_name(n)}/hw08.py": solution_text(HW08) for n in range(2)}))
    desk.write("log.csv", LOG)
    desk.write("roster.csv", roster)
    assert desk("collect", "a.zip", "--from", "moodle", "--roster", "roster.csv", *more)[0] == 0
    desk.write("course.toml", LATE)
    assert desk("grade", "submitted", "--out", "results", "--seed", "1", root=desk.place)[0] == 0
    assert desk("points", "results", "--collected", "collected.csv", root=desk.place)[0] == 0
    scores = {row[0]: float(row[3]) for row in desk.read("results/grades.csv")[1:]}
    assert scores == {who: 5.0 if who in late else 10.0 for who in ("garcia", "obrien")}


# Groups and numbers

TEAMS = [("group", "login"), *((group, login) for login, *_, group in CLASS)]


@pytest.mark.parametrize("how", ["moodle, worksheet", "moodle, table", "canvas, table"])
def test_everybody_of_a_group_gets_its_work(desk, how):
    """Moodle's folders have the group's number, Canvas's files the number of one member."""
    names = {"Team 7": "Team 7_7", "Team 8": "Team 8_17", "Team 9": "Team 9_900"}
    files = {f"{name}_assignsubmission_file/hw08.py": f"# {team}" for team, name in names.items()}
    if how.startswith("canvas"):
        members = {"Team 7": "7", "Team 8": "17", "Team 9": "20"}
        files = {f"{words(team)}_{number}_500_hw08.py": f"# {team}" for team, number in members.items()}
    system = how.split(",")[0]
    desk.write("a.zip", packed(files))
    desk.write("groups.csv", TEAMS)
    desk.write("roster.csv", worksheet(groups=how.endswith("worksheet")) if system == "moodle" else gradebook())
    collect = ["collect", "a.zip", "--from", system, "--roster", "roster.csv"]
    code, said = desk(*collect, *(["--groups", "groups.csv"] if how.endswith("table") else []))
    assert (code, desk.collected) == (0, {login: f"# {group}" for login, *_, group in CLASS}), said


@pytest.mark.parametrize(
    ("system", "name", "more"),
    [
        ("moodle", "Team 8_7_assignsubmission_file/hw08.py", []),
        ("canvas", "team8_7_500_hw08.py", []),
        ("canvas", "team8_7_500_hw08.py", ["--groups", "groups.csv"]),
    ],
)
def test_a_number_whose_name_disagrees_is_not_believed(desk, system, name, more):
    """Number 7 is somebody of another team."""
    desk.write("a.zip", packed({name: "# of team 8"}))
    desk.write("roster.csv", worksheet() if system == "moodle" else gradebook())
    desk.write("groups.csv", TEAMS)
    code, _ = desk("collect", "a.zip", "--from", system, "--roster", "roster.csv", *more)
    assert code == 1 and desk.collected == {}


def test_a_stranger_of_the_same_name_takes_nobodys_place(desk):
    people = [{":name": "Ann Lee", ":email": "ann@else.org"}, {":name": "Ann Lee", ":email": "ann@x.edu", ":sid": "A1"}]
    table = {f"submission_{n}": {":submitters": [who], ":created_at": ""} for n, who in enumerate(people)}
    works = {"submission_0/hw08.py": "# stranger", "submission_1/hw08.py": "# Ann"}
    desk.write("a.zip", packed({"submission_metadata.yml": json.dumps(table), **works}))
    desk.write("roster.csv", [("First Name", "Last Name", "SID", "Email"), ("Ann", "Lee", "A1", "ann@x.edu")])
    code, said = desk("collect", "a.zip", "--from", "gradescope", "--roster", "roster.csv")
    assert code == 1 and desk.collected["A1"] == "# Ann" and "on no row of the roster" in said


def test_a_login_is_no_number(desk):
    """Somebody's login is 17, and user 17 is on no row."""
    desk.write("roster.csv", [row for row in gradebook(column=f"{HW08} (5)") if row[1] != "17"])
    desk.write("a.zip", packed({"smithal_17_5_hw08.py": "# a stranger", "delacruzana_12_6_hw08.py": "# Ana"}))
    code, _ = desk("collect", "a.zip", "--from", "canvas", "--roster", "roster.csv")
    assert code == 1 and desk.collected == {"17": "# Ana"}
    desk.write("roster.csv", gradebook(column=f"{HW08} (5)"))
    desk.write_grades({"17": 9.0})
    desk("lms", "grades.csv", "--to", "canvas", "--roster", "roster.csv", "--out", "up.csv")
    assert {row[3]: row[-1] for row in desk.read("up.csv")[2:] if row[-1]} == {"17": "9.0"}


def test_a_download_is_of_one_assignment(desk):
    """hw08 handed in again in the dropbox of hw07 replaces nothing; what a download replaces is named."""
    desk.write("roster.csv", gradebook())
    collect = ["--from", "canvas", "--roster", "roster.csv"]
    desk.write("a.zip", packed({f"{canvas_name(n)}_hw08.py": f"# {n}" for n in range(4)}))
    assert desk("collect", "a.zip", *collect)[0] == 0
    before = desk.collected
    files = {f"{canvas_name(n, 600)}_hw07.py": f"# {n}" for n in range(3)}
    desk.write("b.zip", packed({**files, f"{canvas_name(3, 600)}_hw08.py": "# again, and late"}))
    code, said = desk("collect", "b.zip", *collect)
    assert code == 1 and desk.collected == before and "is named after hw08" in said
    assert not (desk.place / "submitted" / "ann" / OTHER).exists()
    desk.write("c.zip", packed({f"{canvas_name(3, 700)}_hw08.py": "# newer"}))
    code, said = desk("collect", "c.zip", *collect)
    assert code == 0 and "is replaced by" in said and desk.collected == {**before, "ann": "# newer"}


# Hostile downloads


def test_a_student_fills_no_memory(desk):
    bomb = packed({f"{n}/hw08.py": bytes(10 * 2**20) for n in range(2)})
    files = {f"leeann_17_{n}_hw08.zip": bomb for n in range(60)}
    desk.write("a.zip", packed(files | {"delacruzana_12_6_hw08.py": "# Ana"}))
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
        f"leeann_17_{'9' * 4400}_hw08.py",
    ],
    ids=["control characters", "user", "attachment"],
)
def test_a_long_name_spoils_no_table(desk, name):
    desk.write("a.zip", packed({name: "# x", "delacruzana_12_6_hw08.py": "# Ana"}))
    for _ in range(2):
        code, said = desk("collect", "a.zip", "--from", "canvas")
        assert code == 1 and desk.collected["12"] == "# Ana" and len(said) < 20_000


def test_a_zip_file_of_many_names_is_refused_unread(desk):
    many = packed({f"{n:06}": "" for n in range(30_000)})
    desk.write("a.zip", packed({"leeann_17_5_hw08.zip": many, "delacruzana_12_6_hw08.py": "# Ana"}))
    code, said = desk("collect", "a.zip", "--from", "canvas")
    assert code == 1 and "more than 1000 files" in said and desk.collected == {"12": "# Ana"}


# The other systems


def test_blackboard_and_back(desk):
    rows = [(f"Last{n}", f"First{n}", login, number) for n, (login, number, *_) in enumerate(CLASS)]
    heading = ("Last Name", "First Name", "Username", "Student ID", f"{HW08} [Total Pts: 10 Score] |664617")
    desk.write("gradebook.csv", [heading, *((*row, "") for row in rows)])
    files = {f"HW 8_{login}_attempt_2026-09-14-23-58-00_hw08.py": f"# of {login}" for login in LOGINS}
    files |= {f"HW 8_{login}_attempt_2026-09-14-23-58-00.txt": "Name: x" for login in LOGINS}
    desk.write("a.zip", packed(files))
    code, said = desk("collect", "a.zip", "--from", "blackboard", "--roster", "gradebook.csv")
    assert (code, desk.collected) == (0, {login: f"# of {login}" for login in LOGINS}), said
    assert desk.read("collected.csv")[1][4] == "2026-09-14 23:58:00"
    desk.write_grades({login: n for n, login in enumerate(LOGINS)})
    lms = ["lms", "grades.csv", "--to", "blackboard", "--roster", "gradebook.csv", "--out", "up.csv"]
    assert desk(*lms)[0] == 0
    assert desk.read("up.csv") == [[*heading], *([*row, str(n)] for n, row in enumerate(rows))]


def test_brightspace_and_back(desk):
    people = [(login, first, last) for login, _, last, first, _ in CLASS if last != "Lee"]
    grade, end = "HW 8 Points Grade <Numeric MaxPoints:10>", "End-of-Line Indicator"
    heading = ("OrgDefinedId", "Username", "Last Name", "First Name", grade, end)
    rows = [(f"#{n}", f"#{login}", last, first, "", "#") for n, (login, first, last) in enumerate(people)]
    desk.write("gradebook.csv", [heading, *rows])
    names = [f"{first} {last}" for _, first, last in people]
    files = {f"123-{n} - {name} - Sep 14, 2026 1158 PM/hw08.py": f"# {n}" for n, name in enumerate(names)}
    desk.write("a.zip", packed({**files, "index.html": ""}))
    code, _ = desk("collect", "a.zip", "--from", "brightspace", "--roster", "gradebook.csv")
    assert desk.collected == {login: f"# {n}" for n, (login, *_) in enumerate(people)} and code == 1  # index.html
    desk.write_grades({login: n for n, (login, *_) in enumerate(people)})
    desk.write("course.toml", '[hw08]\nbrightspace = "HW 8"\n')
    lms = ["lms", "grades.csv", "--to", "brightspace", "--roster", "gradebook.csv", "--out", "up.csv"]
    assert desk(*lms, root=desk.place)[0] == 0
    first, *uploaded = desk.read("up.csv")
    assert first == [*heading[:2], grade, end] and uploaded[2] == [*rows[2][:2], "2", "#"]


def test_github_classroom(desk):
    logins = {"ann": "octo-cat", "bo": "hubot", "cy": "mona"}
    for n, user in enumerate(logins.values()):
        folder = desk.place / "repositories" / f"hw08-{user}"
        (folder / ".git").mkdir(parents=True)
        (folder / ".git" / "config.py").write_text("# no work")
        (folder / f"{HW08}.py").write_text(f"# {n}")
    rows = [(login, user, "", "") for login, user in logins.items()]
    desk.write("roster.csv", [("identifier", "github_username", "github_id", "name"), *rows])
    code, said = desk("collect", "repositories", "--from", "github", "--roster", "roster.csv")
    assert (code, desk.collected) == (0, {"ann": "# 0", "bo": "# 1", "cy": "# 2"}), said


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_a_system_lacks_is_a_sentence(desk, name):
    system = SYSTEMS[name]
    desk.write_grades({"ann": 9})
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


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_excused_is_so_in_the_words_of_the_system(desk, system):
    desk.write("canvas.csv", gradebook(column=f"{HW08} (5)"))
    desk.write("moodle.csv", worksheet())
    desk.write_grades({login: "EX" if login == "ann" else 9 for login in LOGINS})
    for roster in ([], ["--roster", f"{system}.csv"]):
        code, said = desk("lms", "grades.csv", "--to", system, *roster, "--out", "up.csv")
        reported = {row[0 if system == "moodle" else 3]: row[-1] for row in desk.read("up.csv")}
        assert code == 0 and reported["ann"] == ("EX" if system == "canvas" else "") and reported["ann2"] == "9", said
