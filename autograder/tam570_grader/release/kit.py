"""Build the students' kit: a wheel with the assignments and the command `tam570`, and a README on how to start.

The wheel's version ends in a digest of its content, so that pip replaces an older kit by a changed one.
"""

import hashlib
import re
import shutil
import tempfile
import tomllib
from pathlib import Path

from tam570.values import Json
from tam570_grader.checks import assignments
from tam570_grader.errors import UsageError, say, writing
from tam570_grader.release.notebook import write_notebook
from tam570_grader.results.tables import written

OF_THE_GRADER = ("msgpack", "tqdm")  # dependencies that only the grader needs
NOT_FOR_STUDENTS = shutil.ignore_patterns("__pycache__", ".*", "*.pyc")
EXAMPLE = "hw08_axis_angle"  # example in the README; in a course without it, the first assignment replaces it
TEMPLATES = Path(__file__).parent / "templates"


def run(course: Path, folder: Path) -> int:
    """Write the kit into a folder; return the exit code."""
    if (folder / "README.md").exists() and not any(folder.glob("tam570-*.whl")):
        raise UsageError(f"the README.md in {folder} is not a kit's; name another folder")
    text = (TEMPLATES / "kit.md").read_text(encoding="utf-8")
    slugs = assignments.slugs(course)
    if EXAMPLE not in slugs:
        function = next(iter(assignments.assignment(course, slugs[0]).returns))
        text = text.replace(EXAMPLE, slugs[0]).replace(EXAMPLE[:4], slugs[0][:4]).replace("rotation_matrix", function)
    held = "\n".join(f"- {slug[:4]}: {assignments.title(course, slug)}" for slug in slugs)
    with writing(folder):
        folder.mkdir(parents=True, exist_ok=True)
        wheel = _wheel(course, folder.resolve())
        written(folder / "README.md", text.replace("{wheel}", wheel.name).replace("{assignments}", held))
        shutil.copyfile(course / "NOTATION.md", folder / "NOTATION.md")
    say(f"{folder}: {wheel.name}, README.md and NOTATION.md, for your students", error=True)
    return 0


def _wheel(course: Path, folder: Path) -> Path:
    """Build the wheel, without solutions, checks and grader, and delete older ones; return its path."""
    try:
        from hatchling.builders.wheel import WheelBuilder
    except ImportError:
        raise UsageError("building the wheel needs hatchling: pip install 'tam570[grader]'") from None
    with tempfile.TemporaryDirectory() as stage:
        version = _staged(course, Path(stage))
        builder = WheelBuilder(stage, config=_project(course, version))
        wheel = Path(next(iter(builder.build(directory=str(folder), versions=["standard"]))))
    for old in folder.glob("tam570-*.whl"):
        if old != wheel:
            old.unlink()
    return wheel


def _staged(course: Path, stage: Path) -> str:
    """Copy the wheel's content into the folder `stage`; return its version."""
    package = stage / "tam570"
    shutil.copytree(course / "shared" / "tam570", package, ignore=NOT_FOR_STUDENTS)
    shutil.copytree(course / "assignments", package / "assignments", ignore=NOT_FOR_STUDENTS)
    for slug in assignments.slugs(course):
        target = package / "assignments" / slug / "notebook"
        target.mkdir()
        write_notebook(course, slug, target)
    for name in ("README.md", "LICENSE"):
        shutil.copyfile(course / name, stage / name)
    digest = hashlib.sha256()
    for path in sorted(path for path in package.rglob("*") if path.is_file()):
        digest.update(f"{path.relative_to(package).as_posix()}\0{path.stat().st_size}\0".encode() + path.read_bytes())
    start = package / "__init__.py"
    text = start.read_text(encoding="utf-8")
    version = re.sub(r'[\s\S]*__version__ = "(.*?)"[\s\S]*', rf"\1+{digest.hexdigest()[:10]}", text)
    start.write_text(re.sub(r'__version__ = ".*?"', f'__version__ = "{version}"', text), encoding="utf-8")
    return version


def _project(course: Path, version: str) -> Json:
    """Return the content of pyproject.toml for the wheel, without the grader."""
    config = tomllib.loads((course / "pyproject.toml").read_text(encoding="utf-8"))
    project: Json = config["project"]
    needed = [library for library in project["dependencies"] if not library.startswith(OF_THE_GRADER)]
    project |= {"version": version, "dynamic": [], "dependencies": needed}
    project["optional-dependencies"] = {"fast": project["optional-dependencies"]["fast"]}
    project["scripts"] = {"tam570": project["scripts"]["tam570"]}
    return {
        "build-system": config["build-system"],
        "project": project,
        "tool": {"hatch": {"build": {"targets": {"wheel": {"packages": ["tam570"]}}}}},
    }
