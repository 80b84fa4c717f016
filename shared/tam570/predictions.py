"""Ask once for the predictions that a problem wants before its picture; store them, and show them with the picture."""

import contextlib
import sys
import textwrap
import time
import tomllib
from pathlib import Path

from tam570.course import folder


def ask_for_predictions(work: Path, slug: str) -> list[str]:
    """Ask on a terminal for each prediction that is not yet in the folder `work`; return a sentence on each."""
    rubric = folder(slug) / "rubric.toml"
    parts = tomllib.loads(rubric.read_text(encoding="utf-8"))["parts"] if rubric.exists() else {}
    return [_prediction(work, letter, part["before"]) for letter, part in parts.items() if "before" in part]


def _prediction(work: Path, letter: str, question: str) -> str:
    path = work / f"prediction_{letter}.txt"
    if not path.is_file():
        print(textwrap.fill(f"Before you look ({letter}): {question}", 80))
        answer = ""
        with contextlib.suppress(EOFError):
            answer = input("Your prediction: ").strip() if _is_attended() else ""
        if not answer:
            return f"({letter}) You have written no prediction into {path.name} yet."
        path.write_text(f"{time.strftime('%Y-%m-%d %H:%M')}: {answer}\n", encoding="utf-8")
    return f"({letter}) You predicted, {' '.join(path.read_text(encoding='utf-8', errors='replace').split())}"


def _is_attended() -> bool:
    return sys.stdin.isatty() and sys.stdout.isatty()
