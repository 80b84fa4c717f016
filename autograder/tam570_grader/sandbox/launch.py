"""Start a zygote: in bubblewrap, where only Python and the course's utilities are visible, or as a plain process."""

import contextlib
import ctypes
import functools
import json
import os
import platform
import re
import shutil
import signal
import socket
import stat
import subprocess
import sys
import tempfile
from collections.abc import Sequence
from pathlib import Path

import tam570
from tam570_grader.errors import UsageError
from tam570_grader.protocol.jail import SCRATCH, hidden_from_debuggers
from tam570_grader.protocol.refusals import CALLS

# Imports `protocol` by its path, so that no other package in its folder can be imported.
BOOT = """
import gc, importlib.util, json, sys
gc.disable()  # nothing is garbage yet, and looking for it takes a fifth of the time of the imports
*path, home = json.loads(sys.argv[1])
sys.path += path
spec = importlib.util.spec_from_file_location("protocol", home + "/protocol/__init__.py")
sys.modules["protocol"] = package = importlib.util.module_from_spec(spec)
spec.loader.exec_module(package)
from protocol.zygote import main
main()
"""
HOME = Path(__file__).parents[1]  # folder of the package `protocol`
TRIALS = 3  # trial runs of bubblewrap: one may be killed, or fail for lack of memory
SYSTEM_LINKS = ("/lib", "/lib64")  # links into /usr on most systems
ARGUMENTS = slice(45, 47)  # arg_start and arg_end among the fields after the name in /proc/self/stat: proc(5)
SEED = re.compile(rb"--se[a-z]*[\0=]([^\0@][^\0]*)")  # --seed in a command line, also abbreviated
VARIABLES = {
    "PATH": "/usr/bin:/bin",
    "LC_ALL": "C.UTF-8",
    "PYTHONHASHSEED": "0",
    "OPENBLAS_NUM_THREADS": "1",
    "OMP_NUM_THREADS": "1",
    "MKL_NUM_THREADS": "1",  # several threads forbid namespaces
    "MPLBACKEND": "agg",
    "TAM570_COMPILED": "0",  # compiling would use up a call's time
}


class LaunchedZygote:
    """A zygote's process, which imports NumPy and then waits for its settings."""

    def __init__(self, command: Sequence[str], folder: str) -> None:
        self.command, self._owner = command, os.getpid()
        self._errors = tempfile.TemporaryFile()  # noqa: SIM115  closed with the process
        self.control, child_end = socket.socketpair()
        with child_end:
            self._process = subprocess.Popen(
                [*command, str(child_end.fileno())],
                pass_fds=[child_end.fileno()],
                env=environment(folder),
                stdin=subprocess.DEVNULL,
                stdout=subprocess.DEVNULL,
                stderr=self._errors,
                start_new_session=True,
            )

    def errors(self) -> str:
        """Return the end of what the process has written to stderr."""
        self._errors.seek(0)
        return self._errors.read()[-500:].decode(errors="replace")

    def wait(self) -> None:
        """Wait until the process has ended."""
        self._process.wait()

    def kill(self) -> None:
        """Kill the process group at once, because the child of a bubblewrap that is still starting survives it."""
        with contextlib.suppress(ProcessLookupError, PermissionError):  # macOS raises the latter if it has ended
            os.killpg(self._process.pid, signal.SIGKILL)

    def close(self) -> None:
        """Close the socket; if this process started the zygote, also kill it and everything in it."""
        self.control.close()
        if os.getpid() == self._owner:
            self.kill()
            self.wait()
        self._errors.close()


_early = list[LaunchedZygote]()  # launched before the hidden folders are known
_trials = list[subprocess.Popen[bytes]]()  # trial runs of bubblewrap that may still be running


def launch_early() -> None:
    """Launch a zygote that starts while this process still imports; `launch` returns it if its command fits.

    Also start a trial run of bubblewrap; if that fails, the zygote is not used.
    """
    if _has_bubblewrap():
        _trials.append(_trial())
        _early.append(LaunchedZygote(jailed_command([]), SCRATCH))


def launch(hidden: Sequence[Path]) -> LaunchedZygote:
    """Return a new zygote that does not see the hidden folders, or the one that was launched early if it fits."""
    what = command(tuple(hidden))
    if _early and _early[0].command == what:
        return _early.pop()
    close_early()
    return LaunchedZygote(what, SCRATCH if isolation() == "bubblewrap" else tempfile.gettempdir())


def close_early() -> None:
    """End the zygote and the trial that `launch_early` started, if they are still unused."""
    while _early:
        _early.pop().close()
    while _trials:
        trial = _trials.pop()
        trial.kill()
        trial.wait()


@functools.cache
def command(hidden: tuple[Path, ...]) -> list[str]:
    """Return the command of a zygote that does not see these folders; most are not visible to it anyway."""
    return jailed_command(hidden) if isolation() == "bubblewrap" else plain_command()


def write_bytecode() -> None:
    """Compile our modules that a zygote imports if they have changed, because it cannot write bytecode itself."""
    import compileall  # imported late: a zygote is launched first

    course = Path(tam570.__file__).parent
    for folder in () if sys.dont_write_bytecode else (HOME / "protocol", course, course / "integrate"):
        compileall.compile_dir(folder, maxlevels=0, quiet=2)


def environment(folder: str) -> dict[str, str]:
    """Return the zygote's environment; files that it writes at its start go to a folder that no submission sees."""
    return {**VARIABLES, "HOME": folder, "TMPDIR": folder, "MPLCONFIGDIR": f"{folder}/matplotlib"}


@functools.cache
def isolation() -> str:
    """Return how submissions are isolated: by "bubblewrap", or only as "processes" if it does not work here."""
    started = [_trials.pop()] if _trials else []
    tries = (started.pop() if started else _trial() for _ in range(TRIALS if _has_bubblewrap() else 0))
    works = any(attempt.wait(timeout=20) == 0 for attempt in tries)
    return "bubblewrap" if works else "processes"


def _has_bubblewrap() -> bool:
    """Return whether bubblewrap is installed, on a system that is supported; it may still fail."""
    return sys.platform == "linux" and platform.machine() in CALLS and shutil.which("bwrap") is not None


def _trial() -> subprocess.Popen[bytes]:
    """Start a trial run of bubblewrap; its exit code is 0 if bubblewrap works."""
    command = ["bwrap", "--unshare-all", "--ro-bind", "/", "/", "true"]
    return subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def hide_from_submissions() -> None:
    """Hide this process's memory, and the seed in its command line, from submissions that are plain processes."""
    if sys.platform != "linux" or isolation() == "bubblewrap":
        return
    stat = Path("/proc/self/stat").read_text(encoding="utf-8", errors="replace")
    start, end = map(int, stat.rpartition(")")[2].split()[ARGUMENTS])
    for seed in SEED.finditer(ctypes.string_at(start, end - start)):
        ctypes.memset(start + seed.start(1), ord("*"), len(seed[1]))
    hidden_from_debuggers()


def _python(path: Sequence[str]) -> list[str]:
    """Return the command of the interpreter outside of any virtual environment; BOOT sets its search path.

    path : the last folder contains `protocol`
    """
    program = os.path.realpath(sys._base_executable)  # type: ignore[attr-defined]
    return [program, "-s", "-S", "-P", "-B", "-c", BOOT, json.dumps(path)]


def _site_folders() -> list[str]:
    return [folder for folder in sys.path if Path(folder).name in ("site-packages", "dist-packages")]


def plain_command() -> list[str]:
    """Return the command of a zygote without a jail."""
    path = [*_site_folders(), str(Path(tam570.__file__).parents[1]), str(HOME)]
    if os.geteuid() == 0:
        _must_be_readable([sys.base_prefix, *path])
    return _python(path)


def _must_be_readable(folders: Sequence[str]) -> None:
    """Raise UsageError if others cannot enter a folder: under root, submissions run as another user."""
    for folder in map(Path, folders):
        closed = [parent for parent in (folder, *folder.parents) if not os.stat(parent).st_mode & stat.S_IXOTH]
        if closed:
            have = "let bubblewrap make namespaces here" if shutil.which("bwrap") else "install bubblewrap"
            raise UsageError(
                f"without bubblewrap, submissions run as another user than root, who may not enter {closed[-1]}: "
                f"{have}, move the course to a folder that everyone may enter, or grade as an ordinary user"
            )


def jailed_command(hidden: Sequence[Path]) -> list[str]:
    """Return the command of a zygote in bubblewrap, which sees Python, its packages and `tam570`."""
    sites = _site_folders()
    course = Path(tam570.__file__).parent
    shown = {folder: folder for folder in [*sites, *_python_folders(), _python([])[0]] if os.path.exists(folder)}
    shown |= {"/opt/course/tam570": str(course), "/opt/grader/protocol": str(HOME / "protocol")}
    binds = [(Path(target), ["--ro-bind", os.path.realpath(source)]) for target, source in shown.items()]
    below = [path for path in hidden if any(path.is_relative_to(target) for target, _ in binds)]
    masks = [(path, ["--tmpfs"]) for path in dict.fromkeys([*below, *other_packages(sites), *_unused_fonts(sites)])]
    command = ["bwrap", "--unshare-pid", "--unshare-ipc", "--unshare-net", "--unshare-uts", "--die-with-parent"]
    for target, mount in sorted(masks + binds, key=lambda entry: len(entry[0].parts)):
        for parent in reversed(target.parents[:-1]):
            command += ["--perms", "0755", "--dir", str(parent)]  # bubblewrap's default is root only
        command += [*mount, str(target)]
    for folder in filter(os.path.islink, SYSTEM_LINKS):
        command += ["--symlink", os.readlink(folder), folder]
    command += ["--ro-bind-try", "/etc/ld.so.cache", "/etc/ld.so.cache", "--proc", "/proc", "--dev", "/dev"]
    command += ["--tmpfs", "/dev/pts", "--remount-ro", "/dev/pts"]  # its times could transfer data
    if not any(target.is_relative_to("/tmp") for target, _ in binds):
        command += ["--symlink", SCRATCH, "/tmp"]
    for path, _ in masks:  # read-only, or submissions could leave data there
        command += ["--remount-ro", str(path)]
    command += ["--tmpfs", SCRATCH, "--remount-ro", "/dev", "--remount-ro", "/", "--chdir", "/", "--"]
    return [*command, *_python([*sites, "/opt/course", "/opt/grader"])]


def other_packages(sites: Sequence[str]) -> list[Path]:
    """Return package folders of other interpreters that are visible; bans hide modules only in our own folders."""
    ours = set(map(os.path.realpath, sites))
    packages = [path for folder in _python_folders() for path in Path(folder).glob("python3*/*-packages")]
    linked = [path for path in packages if path.is_symlink() or path.parent.is_symlink()]
    return [path for path in packages if path not in linked and path.is_dir() and os.path.realpath(path) not in ours]


def _unused_fonts(sites: Sequence[str]) -> list[Path]:
    """Return folders of fonts for PostScript and PDF only, which matplotlib takes long to list."""
    fonts = [Path(folder, "matplotlib/mpl-data/fonts", name) for folder in sites for name in ("afm", "pdfcorefonts")]
    return [folder for folder in fonts if folder.is_dir()]


def _python_folders() -> list[str]:
    """Return the folders of the interpreter's and the system's libraries."""
    libraries = [f"{sys.base_prefix}/{name}" for name in ("lib", "lib64")]
    return [folder for folder in (*libraries, "/usr/lib", "/usr/lib64", *SYSTEM_LINKS) if not os.path.islink(folder)]
