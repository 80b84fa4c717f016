"""Compare `solve` for ten thousand starts of a system at once with heyoka's batches of eight.

    python benchmarks/ensembles.py                    public problems, three tolerances; writes results/ensembles.json
    python benchmarks/ensembles.py --members 1000

Times are processor times, the median of runs in turn, without compiling. `apart` is the median difference of the two
end states, relative to the state: it shows that both have followed the same motions.
"""

import argparse
import statistics
import time
from pathlib import Path

import numpy as np
import record
from run_time import methods, scenes
from tqdm import tqdm

OUTPUT = record.FOLDER / "ensembles.json"
PROBLEMS = ("double pendulum, points", "Duffing", "heavy top", "Lorenz", "Euler's top", "figure eight")
TOLERANCES = (1e-6, 1e-9, 1e-12)
SPREAD = 0.05  # standard deviation of the starts about the problem's
RUNS = 3
SEED = 570


def starts(scene, members):
    """Return (members, n) starts near that of the problem."""
    start = np.array(scene[1], dtype=float)
    return start + SPREAD * np.random.default_rng(SEED).normal(size=(members, len(start)))


def seconds(run):
    began = time.process_time()
    run()
    return time.process_time() - began


def compared(name, members, tolerance):
    """Return a row of the table."""
    scene = scenes.scene(name)
    many = starts(scene, members)
    ours, theirs = methods.ours_from(scene, many, tolerance), methods.heyoka_from(scene, many, tolerance)
    ends, other = ours(), theirs()
    apart = np.abs(ends - other).max(axis=1) / np.abs(other).max(axis=1)
    pairs = [(seconds(ours), seconds(theirs)) for _ in range(RUNS)]
    mine, peers = map(statistics.median, zip(*pairs, strict=True))
    row = {"problem": name, "members": members, "tolerance": tolerance, "seconds": mine, "heyoka": peers}
    return {**row, "ratio": statistics.median(a / b for a, b in pairs), "apart": float(np.median(apart))}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--members", type=int, default=10_000, metavar="M", help="a multiple of eight")
    parser.add_argument("--out", type=Path, default=OUTPUT)
    options = parser.parse_args()
    if options.members % 8 or options.members < 8:
        parser.error(f"--members {options.members}: give a multiple of eight")
    if not methods.available("heyoka"):
        return print("heyoka is not installed, and nothing is compared: pip install heyoka")
    runs = [(name, tolerance) for name in PROBLEMS for tolerance in TOLERANCES]
    rows = [compared(name, options.members, at) for name, at in tqdm(runs, desc="runs", leave=False, disable=None)]
    record.write(options.out, rows=rows)
    for row in rows:
        print(
            f"{row['problem']:24} {row['tolerance']:.0e}  {row['seconds']:7.3f} s, heyoka {row['heyoka']:7.3f} s:"
            f" {row['ratio']:.2f}  apart {row['apart']:.0e}"
        )
    ratios = [row["ratio"] for row in rows]
    print(f"over heyoka: median {statistics.median(ratios):.2f}, worst {max(ratios):.2f}")


if __name__ == "__main__":
    main()
