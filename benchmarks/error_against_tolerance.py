"""Measure error over rtol on problems of the literature, for the compiled and the Python engine.

The error is the largest at twenty times of a run, relative to the largest magnitude of its component, divided by the
factor by which the problem amplifies a relative change of its start. Prints the table; --write keeps it in results/.

    python benchmarks/error_against_tolerance.py --write
"""

import argparse

import numpy as np
import record
from run_time import scenes

from tam570.integrate import solve

TOLERANCES = (1e-6, 1e-8, 1e-10, 1e-12)
FINEST = 1e-15


def errors(rhs, start, end, method):
    """Return the largest error over rtol and the sensitivity of the problem, for each tolerance."""
    t = np.linspace(0, end, 21)
    exact = solve(rhs, t, start, rtol=FINEST)
    size = np.abs(exact).max(axis=0) + 1e-300
    near = solve(rhs, t, np.array(start, dtype=float) * (1 + 1e-8), rtol=FINEST)
    sensitivity = max(1.0, float((np.abs(near - exact) / size).max() / 1e-8))
    runs = [(r, solve(rhs, t, start, rtol=r, method=method)) for r in TOLERANCES]
    return [float((np.abs(states - exact) / size).max() / r / sensitivity) for r, states in runs]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", action="store_true")
    options = parser.parse_args()
    lines = [
        "error / rtol / sensitivity: {command}, {machine}, {date}".format(**record.facts()),
        f"{'':24}" + "".join(f"{f'{r:g}':>18}" for r in TOLERANCES),
    ]
    for name, (rhs, start, end) in scenes.OTHERS.items():
        both = [errors(rhs, start, end, method) for method in ("compiled", "python")]
        lines.append(f"{name:24}" + "".join(f"{f'{a:.2g} / {b:.2g}':>18}" for a, b in zip(*both, strict=True)))
        print(lines[-1], flush=True)
    if options.write:
        (record.FOLDER / "error_against_tolerance.txt").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
