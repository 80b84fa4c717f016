"""Print what the hidden tests look at; pack a student's work into one archive and list what is still empty."""

import contextlib
import json
import re
import textwrap
import tomllib
import zipfile
from collections.abc import Iterator
from pathlib import Path

from tam570.course import folder, stubs
from tam570.loading import Trouble, source_of
from tam570.progress import rows
from tam570.releases import differing, released

# the same sentence in commands and notebooks
HOW = "Hand in the archive that `tam570 handin {name}` makes: it packs your code, notebook, plots and written parts."

# drawings, plots, text
WRITTEN = (".pdf", ".png", ".jpg", ".jpeg", ".heic", ".webp", ".svg", ".gif", ".md", ".txt", ".docx", ".tex")
PLACEHOLDER = "*Your answer*"  # text of a notebook cell that asks for words
ACCURACY = re.compile(r"^Motions are compared .*?(?:\n\n|\Z)", re.MULTILINE | re.DOTALL)  # a paragraph of a README


def before_handing_in(file: Path, slug: str) -> None:
    """Print what the hidden tests look at, and which files beside the work differ from this kit's."""
    print(f"\nBefore you hand in {file.name}:\nThe hidden tests have other inputs than yours. They look at")
    for name, tested in rows(slug).items():
        print(textwrap.fill(f"{name}: {tested}", 80, initial_indent="  ", subsequent_indent="      "))
    readme = (folder(slug) / "README.md").read_text(encoding="utf-8")
    for accuracy in ACCURACY.findall(readme):
        print(textwrap.fill(" ".join(accuracy.split()), 80))
    for name in differing(file.parent, slug):
        print(f"{name} is not as this kit has it: tam570 update {slug[:4]}")
    print(textwrap.fill(HOW.format(name=slug[:4]), 80))


def hand_in(file: Path, slug: str) -> Path:
    """Pack the work beside `file` into `<slug>_handin.zip` there; print its contents and what is still empty."""
    where, archive = file.parent, file.parent / f"{slug}_handin.zip"
    kit = {path.name for path in released(slug, notebook=True)} - {f"{slug}.py", f"{slug}.ipynb"}
    beside = [path for path in sorted(where.iterdir()) if path.suffix.lower() in WRITTEN and path.name not in kit]
    both = file, file.with_suffix(".ipynb")  # without an empty module, which would be graded instead of the notebook
    work = {f"{slug}{path.suffix}": path for path in both if path.is_file()}
    packed = work | {path.name: path for path in beside}
    draft = archive.with_suffix(".part")
    try:
        with zipfile.ZipFile(draft, "w", zipfile.ZIP_DEFLATED) as target:
            for name, path in packed.items():
                target.write(path, name)
        draft.replace(archive)
    finally:
        draft.unlink(missing_ok=True)
    print(f"{archive}\n    {', '.join(packed)}")
    for remark in _empty(packed, slug):
        print(f"    {remark}")
    return archive


def _empty(work: dict[str, Path], slug: str) -> Iterator[str]:
    """Yield a line for each part of the work that is not done yet."""
    if module := work.get(f"{slug}.py"):
        try:
            to_write = stubs((folder(slug) / f"{slug}.py").read_bytes())
            submitted = to_write | stubs(source_of(module))
            if missing := [name for name in to_write if not submitted[name].written]:
                yield f"not written yet: {', '.join(missing)}"
        except (SyntaxError, ValueError, Trouble):
            yield f"Python cannot read {module.name}: tam570 check {slug[:4]} tells why"
    if notebook := work.get(f"{slug}.ipynb"):
        with contextlib.suppress(ValueError, KeyError, TypeError):
            cells = json.loads(notebook.read_bytes())["cells"]
            count = sum("".join(cell["source"]).strip() == PLACEHOLDER for cell in cells)
            if count:
                yield f"{count} of the cells for your answers {'is' if count == 1 else 'are'} empty"
    rubric = folder(slug) / "rubric.toml"
    if rubric.exists() and set(work) == {f"{slug}.py"}:
        parts = ", ".join(tomllib.loads(rubric.read_text(encoding="utf-8"))["parts"])
        yield f"Your teacher grades by hand: part {parts}; you hand in no drawing, plot or words for it"
