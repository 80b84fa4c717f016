"""Measure how long `tam570 show` takes from the command to the page, and how large the page is.

    python benchmarks/show.py            every scene by its reference solution, the best of five runs
    python benchmarks/show.py --peers    also the double pendulum's scene as Matplotlib's own page of pictures

Prints a table and, with --peers, writes results/show.json. Times of one run on one machine; compare them with each
other.
"""

import argparse
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import record

from tam570.course import assignments
from tam570.show import load_student, scene_of

SOLUTIONS = Path(__file__).parents[1] / "solutions"
PENDULUM = "hw07_double_pendulum"
REPEATS = 5


def seconds(command):
    """Return the time of a Python command, s."""
    started = time.perf_counter()
    subprocess.run([sys.executable, *command], capture_output=True, check=True)
    return time.perf_counter() - started


def measured(slug, folder):
    """Measure one scene, from the command to the page."""
    where = folder / f"{slug}.html"
    command = ["-m", "tam570", "show", slug, str(SOLUTIONS / f"{slug}.py"), "--save", str(where)]
    best = min(seconds(command) for _ in range(REPEATS))
    return {"scene": slug, "seconds": best, "bytes": where.stat().st_size}


def by_matplotlib(folder):
    """Measure the double pendulum's scene as Matplotlib's HTMLWriter writes it: a picture for each frame."""
    from matplotlib.animation import HTMLWriter

    from tam570.show.pictures import save_frames

    scene = scene_of(load_student(SOLUTIONS / f"{PENDULUM}.py", PENDULUM), PENDULUM)
    where, started = folder / "matplotlib.html", time.perf_counter()
    writer = HTMLWriter(fps=30, embed_frames=True)
    writer._bytes_limit = 1e9
    save_frames(scene, where, writer, every=2)
    duration = time.perf_counter() - started
    return {"scene": f"{PENDULUM}, matplotlib HTMLWriter", "seconds": duration, "bytes": where.stat().st_size}


def main():
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("--peers", action="store_true")
    peers = parser.parse_args().peers
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        rows = [measured(slug, folder) for slug in assignments()]
        rows += [by_matplotlib(folder)] if peers else []
    for row in rows:
        print(f"{row['scene']:<44} {row['seconds']:6.2f} s {row['bytes'] / 1e3:8.1f} kB")
    if peers:
        record.write(record.FOLDER / "show.json", rows=rows)


if __name__ == "__main__":
    main()
