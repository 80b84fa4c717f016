"""How long `tam570 show` takes from the command to the page, and how large the page is.

    python benchmarks/show.py            every scene by its reference solution, the best of five runs
    python benchmarks/show.py --quick    the double pendulum alone
    python benchmarks/show.py --peers    beside them, the pendulum's film as Matplotlib's own page of pictures

Prints a table and, with --peers, writes results/show.json. Times of one run on one machine; compare them with each
other.
"""

import argparse
import gzip
import json
import re
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record

from tam570.course import assignments
from tam570.show import load_student, scene_of

HERE = Path(__file__).parent
RESULTS = record.RESULTS / "show.json"
SOLUTIONS = HERE.parent / "solutions"
PENDULUM = "hw07_double_pendulum"
REPEATS = 5
STAGES = """
import json, pathlib, sys, time
times = [time.perf_counter()]
from tam570.show import load_student, scene_of
from tam570.show.page import page
slug, file = sys.argv[1:]
times.append(time.perf_counter())
module = load_student(pathlib.Path(file), slug)
times.append(time.perf_counter())
scene = scene_of(module, slug)
times.append(time.perf_counter())
page(scene)
times.append(time.perf_counter())
print(json.dumps([after - before for before, after in zip(times, times[1:])]))
"""


def timed(command):
    """Time of the command, s, and what it printed."""
    started = time.perf_counter()
    run = subprocess.run([sys.executable, *command], capture_output=True, text=True, check=True)
    return time.perf_counter() - started, run.stdout


def measured(slug, folder):
    """One scene: from the command to the page, and what of it is what."""
    file, where = SOLUTIONS / f"{slug}.py", folder / f"{slug}.html"
    command = ["-m", "tam570.cli", "show", slug, str(file), "--save", str(where)]
    seconds = min(timed(command)[0] for _ in range(REPEATS))
    stages = [json.loads(timed(["-c", STAGES, slug, str(file)])[1]) for _ in range(REPEATS)]
    document = where.read_bytes()
    data = re.search(rb'id="data">(.*?)</script>', document, re.S)[1]
    film = json.loads(data)
    names = ("imports", "student's file", "student's functions", "page")
    return {
        "scene": slug,
        "seconds": seconds,
        "of it": {name: min(times) for name, times in zip(names, zip(*stages, strict=True), strict=True)},
        "bytes": len(document),
        "data bytes": len(data),
        "gzip bytes": len(gzip.compress(document)),
        "samples": sum(film["keys"]) + 1,
        "samples kept": len(film["keys"]),
        "points": sum(len(part["at"]) for panel in film["panels"] for part in panel["shapes"]),
        "tracks kept": len(film["tracks"]),
    }


def by_matplotlib(folder):
    """The same film of the double pendulum as Matplotlib's HTMLWriter has it: a picture for each frame."""
    from matplotlib.animation import HTMLWriter
    from matplotlib.figure import Figure

    from tam570.show.pictures import DPI, SIZE, _drawn, frames

    film = scene_of(load_student(SOLUTIONS / f"{PENDULUM}.py", PENDULUM), PENDULUM)
    where, started = folder / "matplotlib.html", time.perf_counter()
    figure = Figure(figsize=SIZE, dpi=DPI)
    update, writer = _drawn(film, figure), HTMLWriter(fps=30, embed_frames=True)
    writer._bytes_limit = 1e9
    with writer.saving(figure, str(where), DPI):
        for sample in frames(film, ".mp4"):
            update(sample)
            writer.grab_frame()
    seconds = time.perf_counter() - started
    return {"scene": f"{PENDULUM}, matplotlib HTMLWriter", "seconds": seconds, "bytes": where.stat().st_size}


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--peers", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rows = [measured(slug, folder) for slug in ([PENDULUM] if arguments.quick else assignments())]
        rows += [by_matplotlib(folder)] if arguments.peers else []
    print(f"{'scene':<44} {'s':>6} {'kB':>8} {'gzip':>6}  samples kept  tracks kept")
    for row in rows:
        print(f"{row['scene']:<44} {row['seconds']:6.2f} {row['bytes'] / 1e3:8.1f}", end="")
        if "samples" in row:
            kept = f"{row['samples kept']}/{row['samples']}"
            print(f" {row['gzip bytes'] / 1e3:6.1f} {kept:>12} {row['tracks kept']:>7}/{row['points']}", end="")
        print()
    if arguments.peers and not arguments.quick:
        record.write(RESULTS, rows=rows)


if __name__ == "__main__":
    main()
