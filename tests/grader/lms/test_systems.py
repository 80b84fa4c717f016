"""Files as each vendor's code writes them, for a class of odd names: all students get their own work and scores."""

import json
import unicodedata

import pytest
from classes import HW08, hand_in, packed

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
    ("lixl", "21", "李", "小龙", "Team 9"),
    ("jm-1", "22", *(unicodedata.normalize("NFD", name) for name in ("Müller", "Jürgen")), "Team 9"),
]
LOGINS = [login for login, *_ in CLASS]
CANVAS_LAYOUTS = [  # gradebook_exporter.rb, csv_data: with and without the SIS ids, with more ids, with split names
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS Login ID", "Section"),
    ("Student", "ID", "SIS User ID", "SIS Login ID", "Integration ID", "Root Account", "Section"),
    ("LastName", "FirstName", "ID", "SIS Login ID", "Section"),
]
LATE = "[late]\noff_a_day = 0.5\n[hw08]\ndue = 2026-09-14T23:59:00\n"
LOG = [["Time", "User full name", "Affected user", "Event context", "Component", "Event name"]] + [
    [f"15/09/26, 10:0{k}:00", "José García Núñez", "-", "Assignment: HW 8", "Assignment", event]
    for k, event in enumerate(("A submission has been submitted.", "The status of the submission has been viewed."))
]
ON_TIME, TOO_LATE = "Monday, 14 September 2026, 11:58 PM", "Tuesday, 15 September 2026, 10:00 AM"
ANA = {"delacruzana_12_6_hw08.py": "# Ana"}
LONG = {"letters": "17_5_" + "\x1b" * 40_000, "user": "1" * 4400 + "_5", "file": "17_" + "9" * 4400}


def words(name):
    """Return a name as `sanitize_file_name` of Canvas's content_zipper.rb does."""
    return "".join(c for c in name.lower() if c.isalnum() or c == "_")


def canvas_name(n, order=500):
    _, number, last, first, _ = CLASS[n]
    return f"{words(f'{last}, {first}')}_{number}_{order}"


def moodle_name(n):
    _, number, last, first, _ = CLASS[n]
    return f"{first} {last}".replace("'", "") + f"_{number}_assignsubmission_file"


def gradebook(layout=CANVAS_LAYOUTS[0], column="HW 8: Rotations (810001)", cells=None):
    """Return Canvas's export of the gradebook, with the rows that are not of students."""
    mine = {"SIS User ID": "S{}", "Integration ID": "I{}", "Root Account": "x.edu", "Section": "570"}
    rows = [[*layout, "Notes", column, "Final Score"], ["", *[""] * len(layout), "Manual Posting", ""]]
    rows.append(["    Points Possible", *[""] * len(layout), "10", "(read only)"])
    for login, number, last, first, _ in [*CLASS, ("f00ba4", "99", "Student", "Test", "")]:
        names = {"Student": f"{last}, {first}", "LastName": last, "FirstName": first}
        fields = {**names, "ID": number, "SIS Login ID": login} | {key: mine[key].format(number) for key in mine}
        rows.append([*(fields[key] for key in layout), "", (cells or {}).get(login, ""), ""])
    return rows


def worksheet(when="Monday, 14 September 2026, 11:59 PM", *, groups=False):
    """Return Moodle's worksheet with columns of gradingtable.php, and usernames instead of email addresses."""
    heading = ["Identifier", "Full name", "Username", "Status", *["Group"] * groups, "Grade"]
    rows = [
        [f"Participant {number}", f"{first} {last}", login, "Submitted", *[group] * groups, "", when]
        for login, number, last, first, group in CLASS
    ]
    return [[*heading, "Last modified (submission)"], *rows]


@pytest.fixture
def upload(desk):
    """`upload(system, *more)` -> (exit code, output, rows of the table) of `lms` with roster.csv."""

    def upload(system, *more, roster=("--roster", "roster.csv")):
        (desk.folder / "up.csv").unlink(missing_ok=True)
        code, printed = desk("lms", "grades.csv", "--to", system, *roster, "--out", "up.csv", *more)
        return code, printed, desk.read("up.csv") if (desk.folder / "up.csv").exists() else []

    return upload


def of_everybody(name):
    """Return the texts to collect, {login: text}, and the files of a download, {name(n): text}."""
    texts = {login: f"# of {login}" for login in LOGINS}
    return texts, {name(n): texts[login] for n, login in enumerate(LOGINS)}


@pytest.mark.parametrize("layout", CANVAS_LAYOUTS, ids=lambda layout: f"{len(layout)} from {layout[0]}")
def test_a_class_from_canvas_to_canvas(desk, download, upload, layout):
    expected, files = of_everybody(lambda n: f"{canvas_name(n)}_hw08.py")
    code, printed = download("canvas", files, gradebook(layout, cells={"obrien": "EX"}))
    assert (code, desk.collected) == (0, expected), printed
    desk.write_grades({login: n + 0.5 for n, login in enumerate(LOGINS)})
    code, printed, rows = upload("canvas")
    assert code == 2 and "HW 8: Rotations (810001)" in printed and not rows
    assert upload("canvas", "--new")[2][0][-1] == HW08
    for text in ('canvas = "HW 8: Rotations (810001)"', "canvas = 810001", 'canvas = "HW 8: Rotations"'):
        desk.trust(f"[hw08]\n{text}\n")
        code, _, (heading, possible, *rows) = upload("canvas")
        before = {row[list(layout).index("ID")]: row[: len(layout)] for row in gradebook(layout)[3:-1]}
        assert code == 0 and heading == [*layout, "HW 8: Rotations (810001)"] and possible[-1] == "10"
        after = {row[list(layout).index("ID")]: row for row in rows}
        assert {key: row[:-1] for key, row in after.items()} == before  # without a row for the test student
        points = [after[number][-1] for _, number, *_ in CLASS]
        assert points == ["EX", *(f"{n + 0.5}" for n in range(1, len(CLASS)))]


def test_a_score_that_was_changed_in_the_gradebook_stays_and_is_named(desk, upload):
    desk.write("roster.csv", gradebook(column=f"{HW08} (5)", cells={"ann": "9", "ann2": "4.00", "hw7": "N/A"}))
    desk.write_grades(dict.fromkeys(LOGINS, 4.0))
    for more, code, ann in (([], 1, "9"), (["--overwrite"], 0, "4.0")):
        actual, printed, rows = upload("canvas", *more)
        points = {row[3]: row[-1] for row in rows[2:]}
        assert actual == code and (points["ann"], points["hw7"], points["obrien"]) == (ann, "N/A", "4.0")
        assert ("Lee, Ann keeps 9" in printed) == (code == 1)


@pytest.mark.parametrize("form", ["{}/hw08.py", "{}_/hw08.py", "{}_hw08.py"])  # downloader.php, and Moodle before 4.1
def test_a_class_from_moodle(desk, download, form):
    expected, files = of_everybody(lambda n: form.format(moodle_name(n)))
    code, printed = download("moodle", files, worksheet())
    assert (code, desk.collected) == (0, expected), printed


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_left_out_is_named_and_the_code_is_1(desk, upload, system):
    desk.write("roster.csv", gradebook(column=f"{HW08} (5)") if system == "canvas" else worksheet())
    desk.write_grades(dict.fromkeys([*LOGINS[:1], *LOGINS[2:], "ghost"], 9))
    code, printed, _ = upload(system)
    assert code == 1 and printed.count("warning: ") == 2
    assert "ghost has scores and is on no row of the roster" in printed and "(garcia) has no score in hw08" in printed


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
def test_moodles_zip_tells_no_time(desk, download, roster, more, late):
    """Files have the date of the download, so times come from a worksheet or a log; without one nobody is late."""
    desk.write("log.csv", LOG)
    assert download("moodle", {f"{moodle_name(n)}/hw08.py": "x" for n in range(2)}, roster, *more)[0] == 0
    desk.trust(LATE)
    desk.write_results(dict.fromkeys((("garcia", HW08), ("obrien", HW08)), 10.0))
    assert desk("points", "results", "--collected", "collected.csv")[0] == 0
    assert desk.scores() == {login: 5.0 if login in late else 10.0 for login in ("garcia", "obrien")}


@pytest.mark.parametrize(
    ("days", "when", "is_warned"),
    [
        (("09/14/26", "09/12/26"), "2026-09-12", False),
        (("14/09/26", "12/09/26"), "2026-09-12", False),
        (("12/09/26",), "2026-09-12", True),
    ],
)
def test_all_dates_of_a_log_have_one_order(desk, download, days, when, is_warned):
    name, other, event = "José García Núñez", "Pat O'Brien", "A submission has been submitted."
    rows = [[f"{day}, 10:00:00", who, event] for day, who in zip(days, (other, name), strict=False)]
    rows[-1][1] = name
    desk.write("log.csv", [("Time", "User full name", "Event name"), *rows])
    roster = [row[:3] for row in worksheet()]
    _, printed = download("moodle", {f"{moodle_name(1)}/hw08.py": "x"}, roster, "--times", "log.csv")
    assert desk.rows("collected.csv")[0]["when"] == f"{when} 10:00:00" and ("could begin" in printed) == is_warned


TEAMS = [("group", "login"), *((group, login) for login, *_, group in CLASS)]


@pytest.mark.parametrize("way", ["moodle, worksheet", "moodle, table", "canvas, table"])
def test_everybody_of_a_group_gets_its_work(desk, download, way):
    """Moodle's folders have the group's number, Canvas's files the number of one member."""
    system, more = way.split(",")[0], ["--groups", "groups.csv"] if way.endswith("table") else []
    folders = {"Team 7": "Team 7_7", "Team 8": "Team 8_17", "Team 9": "Team 9_900"}
    files = {f"{folder}_assignsubmission_file/hw08.py": f"# {team}" for team, folder in folders.items()}
    roster = worksheet(groups=way.endswith("worksheet"))
    if system == "canvas":
        members = {"Team 7": "7", "Team 8": "17", "Team 9": "20"}
        files = {f"{words(team)}_{number}_500_hw08.py": f"# {team}" for team, number in members.items()}
        roster = gradebook()
    desk.write("groups.csv", TEAMS)
    code, printed = download(system, files, roster, *more)
    assert (code, desk.collected) == (0, {login: f"# {group}" for login, *_, group in CLASS}), printed


@pytest.mark.parametrize(
    ("system", "name", "more"),
    [
        ("moodle", "Team 8_7_assignsubmission_file/hw08.py", []),
        ("canvas", "team8_7_500_hw08.py", []),
        ("canvas", "team8_7_500_hw08.py", ["--groups", "groups.csv"]),
    ],
)
def test_a_number_whose_name_disagrees_is_not_believed(desk, download, system, name, more):
    """The name says Team 8, but number 7 is a student of Team 7."""
    desk.write("groups.csv", TEAMS)
    code, _ = download(system, {name: "# of team 8"}, worksheet() if system == "moodle" else gradebook(), *more)
    assert code == 1 and desk.collected == {}


def test_a_stranger_of_the_same_name_takes_nobodys_place(desk, download):
    people = [{":name": "Ann Lee", ":email": "ann@else.org"}, {":name": "Ann Lee", ":email": "ann@x.edu", ":sid": "A1"}]
    table = {f"submission_{n}": {":submitters": [who], ":created_at": ""} for n, who in enumerate(people)}
    works = {"submission_0/hw08.py": "# stranger", "submission_1/hw08.py": "# Ann"}
    roster = [("First Name", "Last Name", "SID", "Email"), ("Ann", "Lee", "A1", "ann@x.edu")]
    code, printed = download("gradescope", {"submission_metadata.yml": json.dumps(table), **works}, roster)
    assert code == 1 and desk.collected["A1"] == "# Ann" and "on no row of the roster" in printed


def test_a_login_is_no_number(desk, download, upload):
    """One student's login is 17; the file of user 17, who is not on the roster, is not that student's."""
    roster = [row for row in gradebook(column=f"{HW08} (5)") if row[1] != "17"]
    code, _ = download("canvas", {"smithal_17_5_hw08.py": "# a stranger", "delacruzana_12_6_hw08.py": "# Ana"}, roster)
    assert code == 1 and desk.collected == {"17": "# Ana"}
    desk.write("roster.csv", gradebook(column=f"{HW08} (5)"))
    desk.write_grades({"17": 9.0})
    assert {row[3]: row[-1] for row in upload("canvas")[2][2:] if row[-1]} == {"17": "9.0"}


def test_a_download_is_of_one_assignment(desk, download):
    """A file of hw08 in a download of hw07 replaces nothing; `collect` names the files that a download replaces."""
    assert download("canvas", {f"{canvas_name(n)}_hw08.py": f"# {n}" for n in range(4)}, gradebook())[0] == 0
    before = desk.collected
    files = {f"{canvas_name(n, 600)}_hw07.py": f"# {n}" for n in range(3)}
    code, printed = download("canvas", {**files, f"{canvas_name(3, 600)}_hw08.py": "# again, and late"}, gradebook())
    assert code == 1 and desk.collected == before and "is named after hw08" in printed
    assert not (desk.folder / "submitted" / "ann" / OTHER).exists()
    code, printed = download("canvas", {f"{canvas_name(3, 700)}_hw08.py": "# newer"}, gradebook())
    assert code == 0 and "is replaced by" in printed and desk.collected == {**before, "ann": "# newer"}


@pytest.mark.parametrize("name", LONG.values(), ids=LONG)
def test_a_long_name_spoils_no_table(desk, download, name):
    for _ in range(2):
        code, printed = download("canvas", {f"leeann_{name}_hw08.py": "# x"} | ANA)
        assert code == 1 and desk.collected["12"] == "# Ana" and len(printed) < 20_000


def test_blackboard_and_back(desk, download, upload):
    people = [*CLASS, ("j_ann", "23")]  # another student is ann
    rows = [(f"Last{n}", f"First{n}", login, number) for n, (login, number, *_) in enumerate(people)]
    heading = ("Last Name", "First Name", "Username", "Student ID", f"{HW08} [Total Pts: 10 Score] |664617")
    logins = [row[2] for row in rows]
    files = {f"HW_8_{login}_attempt_2026-09-14-23-58-00_hw08.py": f"# of {login}" for login in logins}
    files |= {f"HW_8_{login}_attempt_2026-09-14-23-58-00.txt": "Name: x" for login in logins}
    code, printed = download("blackboard", files, [heading, *((*row, "") for row in rows)])
    assert (code, desk.collected) == (0, {login: f"# of {login}" for login in logins}), printed
    assert desk.read("collected.csv")[1][4] == "2026-09-14 23:58:00"
    desk.write_grades({login: n for n, login in enumerate(logins)})
    for _ in range(2):
        code, _, table = upload("blackboard")
        assert code == 0 and table == [[*heading], *([*row, str(n)] for n, row in enumerate(rows))]
        lines = ["\t".join(cells) for cells in (heading, *((*row, "") for row in rows))]  # its other format
        desk.write("roster.csv", "\n".join(lines).encode("utf-16"))


def test_brightspace_and_back(desk, download, upload):
    people = [(login, first, last) for login, _, last, first, _ in CLASS if last != "Lee"]
    grade, end = "HW 8 Points Grade <Numeric MaxPoints:10>", "End-of-Line Indicator"
    heading = ("OrgDefinedId", "Username", "Last Name", "First Name", grade, end)
    rows = [(f"#{n}", f"#{login}", last, first, "", "#") for n, (login, first, last) in enumerate(people)]
    names = [f"{first} {last}" for _, first, last in people]
    files = {f"123-{n} - {name} - Sep 14, 2026 1158 PM/hw08.py": f"# {n}" for n, name in enumerate(names)}
    code, _ = download("brightspace", {**files, "index.html": ""}, [heading, *rows])
    assert desk.collected == {login: f"# {n}" for n, (login, *_) in enumerate(people)} and code == 0
    desk.write_grades({login: n for n, (login, *_) in enumerate(people)})
    desk.trust('[hw08]\nbrightspace = "HW 8"\n')
    code, _, (first, *uploaded) = upload("brightspace")
    assert code == 0 and first == [*heading[:2], grade, end] and uploaded[2] == [*rows[2][:2], "2", "#"]


def test_github_classroom(desk):
    logins = {"ann": "octo-cat", "bo": "hubot", "cy": "mona"}
    for n, user in enumerate(logins.values()):
        hand_in(desk.folder / "repositories", {f"hw08-{user}": "# no work"}, file=".git/config.py")
        name, work = (f"{HW08}.py", f"# {n}") if n else ("handin.zip", packed({f"{HW08}.py": "# 0"}))
        hand_in(desk.folder / "repositories", {f"hw08-{user}": work}, file=name)
    rows = [(login, user, "", "") for login, user in logins.items()]
    desk.write("roster.csv", [("identifier", "github_username", "github_id", "name"), *rows])
    code, printed = desk("collect", "repositories", "--from", "github", "--roster", "roster.csv")
    assert (code, desk.collected) == (0, {"ann": "# 0", "bo": "# 1", "cy": "# 2"}), printed


@pytest.mark.parametrize("name", SYSTEMS)
def test_what_a_system_lacks_is_a_sentence(desk, name):
    system = SYSTEMS[name]
    desk.write_grades({"ann": 9})
    desk.write("collected.csv", [("student", "name", "assignment", "file", "when", "late", "from", "note")])
    if system.table is None:
        with pytest.raises(SystemExit):
            desk("lms", "grades.csv", "--to", name)
    else:
        code, printed = desk("lms", "grades.csv", "--to", name)
        assert code == 0 and "9" in printed
        pages = ["--pages", "p.zip", "--collected", "collected.csv"]
        assert desk("lms", "grades.csv", "--to", name, *pages)[0] == 2
    assert (name in COLUMNS) == bool(system.table and system.table.must_match)


@pytest.mark.parametrize("system", ["canvas", "moodle"])
def test_who_is_excused_is_so_in_the_words_of_the_system(desk, upload, system):
    desk.write("roster.csv", gradebook(column=f"{HW08} (5)") if system == "canvas" else worksheet())
    desk.write_grades({login: "EX" if login == "ann" else 9 for login in LOGINS})
    for roster in ([], ["--roster", "roster.csv"]):
        code, printed, rows = upload(system, roster=roster)
        grades = {row[0 if system == "moodle" else 3]: row[-1] for row in rows}
        assert code == 0 and grades["ann"] == ("EX" if system == "canvas" else "") and grades["ann2"] == "9", printed
