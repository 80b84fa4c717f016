"""Build a release, and try it in a bare environment of each installed Python.

    make release        writes a wheel and an sdist into dist/; on an error, prints the reason and exits with code 1

The version is in `shared/tam570/__init__.py`; CHANGELOG.md and CITATION.cff must have the same version.
"""

import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import zipfile
from pathlib import Path

COURSE = Path(__file__).resolve().parent.parent
DIST = COURSE / "dist"
PYTHONS = ("3.11", "3.12", "3.13", "3.14")
SECRETS = re.compile(r"(^|/)(solutions|checks|mistakes|tests|benchmarks)/")
TRIALS = {  # command to run after the installation: its exit code
    "tam570 --version": 0,
    "tam570 list": 0,
    "tam570 start hw08": 0,
    "tam570 check hw08": 1,  # nothing is written yet
    "tam570 show oscillator --save a.html": 0,
    "tam570 completion bash": 0,
    "python -m tam570 --version": 0,
}


def main():
    version = agreed_version()
    wheel, sdist = built()
    check_contents(wheel, sdist, version)
    pythons = {name: path for name in PYTHONS if (path := python(name))}
    for path in pythons.values():
        tried(path, wheel, version)
    tried(next(iter(pythons.values())), sdist, version)
    absent = [name for name in PYTHONS if name not in pythons]
    print(f"tam570 {version}: {wheel.name} works with Python {', '.join(pythons)}; {sdist.name} works too")
    print(f"not tried, because not here: Python {', '.join(absent)}" if absent else "every Python was here")
    print(f"to publish: git tag v{version} && git push origin v{version}, then upload dist/")


def agreed_version():
    """Return the version; exit if a file names another one."""
    version = re.search(r'__version__ = "(.+)"', (COURSE / "shared/tam570/__init__.py").read_text())[1]
    if f"\n## {version}\n" not in (COURSE / "CHANGELOG.md").read_text():
        sys.exit(f"CHANGELOG.md has no section for {version}")
    if f"\nversion: {version}\n" not in (COURSE / "CITATION.cff").read_text():
        sys.exit(f"CITATION.cff names another version than {version}")
    return version


def built():
    shutil.rmtree(DIST, ignore_errors=True)
    subprocess.run([sys.executable, "-m", "hatchling", "build", "-d", str(DIST)], cwd=COURSE, check=True)
    (wheel,), (sdist,) = DIST.glob("*.whl"), DIST.glob("*.tar.gz")
    return wheel, sdist


def check_contents(wheel, sdist, version):
    """Exit unless the wheel is pure and contains every assignment, and neither file contains a solution or a check."""
    with zipfile.ZipFile(wheel) as archive:
        names = archive.namelist()
    with tarfile.open(sdist) as archive:
        sources = [name.partition("/")[2] for name in archive.getnames()]
    if not wheel.name.endswith("-py3-none-any.whl") or version not in wheel.name:
        sys.exit(f"{wheel.name} is not a pure wheel of {version}")
    if secret := [name for name in [*names, *sources] if SECRETS.search(name) and "tam570_grader" not in name]:
        sys.exit(f"these files must stay out of a release: {', '.join(secret)}")
    if missing := [path.name for path in (COURSE / "assignments").glob("hw*") if f"/{path.name}/" not in str(names)]:
        sys.exit(f"{wheel.name} lacks {', '.join(missing)}")


def python(version):
    """Return the path of a working Python of this version, or None."""
    for path in [shutil.which(f"python{version}"), *Path.home().glob(f".pyenv/versions/{version}.*/bin/python")]:
        ask = [str(path), "-c", "import sys, venv; print('%d.%d' % sys.version_info[:2])"]
        if path and subprocess.run(ask, capture_output=True, text=True).stdout.strip() == version:
            return str(path)
    return None


def tried(interpreter, package, version):
    """Install a package into a bare environment and run the trials there; exit if one fails."""
    print(f"{package.name} into a bare environment of {interpreter}", flush=True)
    with tempfile.TemporaryDirectory() as folder:
        bare = Path(folder, "bare")
        subprocess.run([interpreter, "-m", "venv", str(bare)], check=True)
        pip = [str(bare / "bin" / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
        subprocess.run([*pip, str(package)], check=True)
        environment = {**os.environ, "PATH": f"{bare / 'bin'}{os.pathsep}{os.environ['PATH']}", "HOME": folder}
        for command, code in TRIALS.items():
            done = subprocess.run(command.split(), cwd=folder, env=environment, capture_output=True, text=True)
            if done.returncode != code or ("--version" in command and version not in done.stdout):
                sys.exit(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")


if __name__ == "__main__":
    main()
