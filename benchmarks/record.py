"""Write a benchmark's tables to results/: JSON with machine, date and command, numbers of three digits."""

import json
import os
import platform
import shlex
import sys
from datetime import date
from pathlib import Path

FOLDER = Path(__file__).parent / "results"
WIDTH = 120  # characters of a line; a list of numbers takes one line however long


def facts():
    """Return the machine, the date and the command of this process."""
    processor = platform.processor() or platform.machine()
    return {
        "machine": f"{processor}, {os.cpu_count()} cores, Python {platform.python_version()}",
        "date": str(date.today()),
        "command": shlex.join(["python", f"benchmarks/{Path(sys.argv[0]).name}", *sys.argv[1:]]),
    }


def write(path, **tables):
    """Write the facts and the tables to `path`."""
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(_text(rounded({**facts(), **tables})) + "\n", encoding="utf-8")


def read(path):
    """Return what `write` wrote; an empty dict if there is no such file."""
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else {}


def rounded(value):
    """Return tables with three digits of each float."""
    if isinstance(value, dict):
        return {key: rounded(item) for key, item in value.items()}
    if isinstance(value, list | tuple):
        return [rounded(item) for item in value]
    return float(f"{value:.3g}") if isinstance(value, float) else value


def _text(value, indent=""):
    line = json.dumps(value, ensure_ascii=False, separators=(",", ":"))
    if len(indent + line) <= WIDTH or "{" not in line:
        return line
    inner = indent + " "
    if isinstance(value, dict):
        items, ends = [f"{json.dumps(key)}:{_text(item, inner)}" for key, item in value.items()], "{}"
    else:
        items, ends = [_text(item, inner) for item in value], "[]"
    return ends[0] + ",".join(f"\n{inner}{item}" for item in items) + f"\n{indent}{ends[1]}"
