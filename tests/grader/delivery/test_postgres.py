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

pytestmark = pytest.mark.every  # half a minute of nbgrader
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

    def stop(self):
        self._does("pg_ctl", "-w", "-m", "immediate", "-D", str(self._folder), "stop")

    def _does(self, program, *arguments):
        done = [*self._user, str(self._programs / program), *arguments]
        subprocess.run(done, check=True, stdout=subprocess.DEVNULL, cwd="/")


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


def test_a_server_that_is_lost_costs_nobody_a_grade(tmp_path, server, made_course, nbgrader, solution_text):
    course, _ = made_course(tmp_path, [SLUG])
    config = course / "nbgrader_config.py"
    config.write_text(config.read_text().replace("# c.CourseDirectory.db_url = ", "c.CourseDirectory.db_url = ", 1))
    config.write_text(config.read_text().replace("postgresql://teacher@localhost/gradebook", server.url))
    nbgrader(course, "generate_assignment", SLUG)
    for student in STUDENTS:
        folder = course / "submitted" / student / SLUG
        shutil.copytree(course / "release" / SLUG, folder)
        (folder / f"{SLUG}.py").chmod(0o644)
        (folder / f"{SLUG}.py").write_text(solution_text(SLUG))
    nbgrader(course, "autograde", SLUG, "--student", "ann")
    server.stop()
    assert "OperationalError" in nbgrader(course, "autograde", SLUG, fails=True)
    assert (course / "autograded" / "ann" / SLUG / f"{SLUG}.ipynb").exists()
    server.start()
    nbgrader(course, "autograde", SLUG)
    nbgrader(course, "generate_feedback", SLUG)
    nbgrader(course, "export")
    rows = csv.DictReader((course / "grades.csv").read_text().splitlines())
    assert {row["student_id"]: float(row["score"]) for row in rows} == dict.fromkeys(STUDENTS, 10.0)
    assert not (course / "gradebook.db").exists()
