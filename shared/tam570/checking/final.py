"""What a student should know before handing in, beyond the visible tests."""

import re
import textwrap
from pathlib import Path

from tam570.course import folder
from tam570.handin import HOW
from tam570.progress import rows
from tam570.releases import differing

ACCURACY = re.compile(r"^Motions are compared .*?(?:\n\n|\Z)", re.MULTILINE | re.DOTALL)


def before_handing_in(file: Path, slug: str) -> None:
    """Print what the hidden tests look at, and what in the folder is out of date."""
    print(f"\nBefore you hand in {file.name}:\nThe hidden tests have other inputs than yours. They look at")
    for name, tested in rows(slug).items():
        print(textwrap.fill(f"{name}: {tested}", 80, initial_indent="  ", subsequent_indent="      "))
    readme = (folder(slug) / "README.md").read_text(encoding="utf-8")
    for accuracy in ACCURACY.findall(readme):
        print(textwrap.fill(" ".join(accuracy.split()), 80))
    for name in differing(file.parent, slug):
        print(f"{name} is not as this kit has it: tam570 update {slug[:4]}")
    print(textwrap.fill(HOW.format(name=slug[:4]), 80))
