"""nbgrader's gradebook in a PostgreSQL database, from release to the table; the server is lost in the middle."""

import csv
import os
import pwd
import shutil
import socket
import subprocess
import tempfile
from pathlib import Path

import pytest

pytestmark = pytest.mark.slow  # half a minute of nbgrader
SLUG = "hw08_axis_angle"
STUDENTS = ("ann", "ben", "cas")
SERVER = "postgres"  # the user: PostgreSQL refuses to run as root


class Server:
    """A PostgreSQL server of one test."""

    def __init__(self, programs, folder):
        self._programs, self._folder = programs, folder
        self._user = ["runuser", "-u", SERVER, "--"] if os.geteuid() == 0 else []
        with socket.socket() as free:
            free.bind(("127.0.0.1", 0))
            self.port = free.getsockname()[1]
        self._does("initdb", "--auth=trust", f"--username={SERVER}", "-D", str(folder))

    @property
    def url(self):
        return f"postgresql://{SERVER}@127.0.0.1:{self.port}/postgres"

    def start(self):
        options = f"-p {self.port} -k {self._folder} -c listen_addresses=127.0.0.1"
        self._does("pg_ctl", "-w", "-D", str(self._folder), "-o", options, "-l", str(self._folder / "log"), "start")

    @property
    def stopping(self):
        """The command that stops it as a crash would."""
        return self._command("pg_ctl", "-w", "-m", "immediate", "-D", str(self._folder), "stop")

    def stop(self):
        subprocess.run(self.stopping, check=True, stdout=subprocess.DEVNULL, cwd="/")

    def _does(self, *command):
        subprocess.run(self._command(*command), check=True, stdout=subprocess.DEVNULL, cwd="/")

    def _command(self, program, *arguments):
        return [*self._user, str(self._programs / program), *arguments]


@pytest.fixture
def server():
    pytest.importorskip("psycopg", reason="no psycopg: pip install 'tam570[postgres]'")
    found = [*Path("/usr/lib/postgresql").glob("*/bin/initdb"), *filter(None, [shutil.which("initdb")])]
    if not found:
        pytest.skip("there is no PostgreSQL here: apt-get install postgresql")
    with tempfile.TemporaryDirectory() as name:  # pytest's own are for root alone
        folder = Path(name)
        if os.geteuid() == 0:
            folder.chmod(0o755)
            os.chown(folder, pwd.getpwnam(SERVER).pw_uid, -1)
        made = Server(Path(found[0]).parent, folder / "data")
        made.start()
        yield made
        made.stop()


# nbgrader's configuration of a test: at the statement whose number stands in the file `lost` the server stops
STOPPING = """
import os, subprocess
from sqlalchemy import event
from sqlalchemy.engine import Engine

@event.listens_for(Engine, "before_cursor_execute")
def _count(*_):
    if os.path.exists("lost"):
        left = int(open("lost").read()) - 1
        open("lost", "w").write(str(left))
        if left == 0:
            os.remove("lost")
            subprocess.run({stop!r}, check=True, cwd="/", stdout=subprocess.DEVNULL)
"""


@pytest.fixture
def course(tmp_path, server, made_course):
    """A course whose gradebook is on the server, with an exchange."""
    made, _ = made_course(tmp_path, [SLUG])
    config = made / "nbgrader_config.py"
    text = config.read_text().replace("# c.CourseDirectory.db_url = ", "c.CourseDirectory.db_url = ", 1)
    text = text.replace("postgresql://teacher@localhost/gradebook", server.url)
    config.write_text(text + STOPPING.format(stop=server.stopping))
    return made


@pytest.fixture
def lost(course, server, nbgrader):
    """`lost(n, *command)`: the server is lost at the command's n-th statement; it is started again after that."""

    def lost(number, *command):
        (course / "lost").write_text(str(number))
        log = nbgrader(course, *command, fails=True)
        assert not (course / "lost").exists()  # else it was not lost in the command
        (line,) = [line for line in log.splitlines() if "does not answer" in line]
        assert log.splitlines()[-1] == line and str(server.port) in line and "same command again" in line
        assert "Traceback" not in log
        server.start()

    return lost


def test_a_command_whose_server_is_lost_says_so_and_finishes_when_given_again(course, lost, nbgrader, solution_text):
    lost(40, "generate_assignment", SLUG)
    assert not (course / "release" / SLUG).exists()
    nbgrader(course, "generate_assignment", SLUG)
    nbgrader(course, "release_assignment", SLUG)
    for student in STUDENTS:
        folder = course / "submitted" / student / SLUG
        shutil.copytree(course / "release" / SLUG, folder)
        (folder / f"{SLUG}.py").chmod(0o644)
        (folder / f"{SLUG}.py").write_text(solution_text(SLUG))
    lost(1, "collect", SLUG)
    nbgrader(course, "collect", SLUG)
    for statement in (60, 200):  # of the first student, and after the first
        lost(statement, "autograde", SLUG)
        done = [*course.glob(f"autograded/*/{SLUG}")]
        assert all((one / f"{SLUG}.ipynb").exists() for one in done) and bool(done) == (statement == 200)
        assert not (course / "autograded" / STUDENTS[-1] / SLUG).exists()
    nbgrader(course, "autograde", SLUG)
    lost(30, "generate_feedback", SLUG)
    nbgrader(course, "generate_feedback", SLUG)
    assert len(list(course.glob(f"feedback/*/{SLUG}/{SLUG}.html"))) == len(STUDENTS)
    (course / "grades.csv").write_text("of the last time")
    lost(20, "export")
    assert (course / "grades.csv").read_text() == "of the last time" and not (course / "grades.csv.new").exists()
    nbgrader(course, "export")
    rows = csv.DictReader((course / "grades.csv").read_text().splitlines())
    assert {row["student_id"]: float(row["score"]) for row in rows} == dict.fromkeys(STUDENTS, 10.0)
    assert not (course / "gradebook.db").exists()


def test_a_server_that_is_not_there_is_named_without_its_password(course, server, nbgrader):
    config = course / "nbgrader_config.py"
    config.write_text(config.read_text().replace("//postgres@", "//postgres:secret@"))
    server.stop()
    log = nbgrader(course, "generate_assignment", SLUG, fails=True)
    server.start()
    assert "does not answer" in log.splitlines()[-1] and "secret" not in log
