"""The site, built once, and served from this machine."""

import functools
import http.server
import os
import subprocess
import sys
import threading
from pathlib import Path

import pytest


class Quiet(http.server.SimpleHTTPRequestHandler):
    def log_message(self, *_):
        """Log nothing, because a page makes dozens of requests."""


@pytest.fixture(scope="session")
def site(course, tmp_path_factory):
    """Build the site, with warnings as errors, and return its folder; TAM570_SITE names one that is already built."""
    if built := os.environ.get("TAM570_SITE"):
        return Path(built).absolute()
    folder = tmp_path_factory.mktemp("site")
    command = [sys.executable, "-m", "sphinx", "-q", "-W", "-j", "auto", "-b", "html", "-d", str(folder / "read")]
    run = subprocess.run([*command, str(course / "docs"), str(folder / "site")], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr
    return folder / "site"


@pytest.fixture(scope="session")
def address(site):
    """Yield the address of a server for the site on this machine."""
    with http.server.ThreadingHTTPServer(("127.0.0.1", 0), functools.partial(Quiet, directory=str(site))) as server:
        threading.Thread(target=server.serve_forever, daemon=True).start()
        yield f"http://127.0.0.1:{server.server_port}/"
        server.shutdown()
