"""Measure run time against error of every method and installed peer, on the assignments' scenes and other problems.

The error is that of the end state, its largest component over the largest of the state, against a reference to 30
digits. Times are processor times: a warm one is the least of repeated runs, with the methods in turn; that of compiling
is how much longer the first run of a right-hand side took; a cold one is that of a new process, imports and compilation
included, on three scenes, at the first tolerance that reaches an error of 1e-9.

    python benchmarks/run_time_against_error.py            all methods; writes results/run_time_against_error.json
    python benchmarks/run_time_against_error.py --peers    compiled, all problems; run_time_against_peers.json
    python benchmarks/run_time_against_error.py --quick    three scenes, four tolerances, no cold processes
    python benchmarks/run_time_against_error.py --methods "tam570, prepared" heyoka CyRK --sets public --out FILE
"""

import argparse
import json
import os
import resource
import subprocess
import sys
import tempfile
import time
import warnings
from pathlib import Path

import mpmath
import numpy as np
import record
from run_time import comparison, extrapolation, methods, scenes
from tqdm import tqdm

OUTPUT = record.FOLDER / "run_time_against_error.json"
PEERS_OUTPUT = record.FOLDER / "run_time_against_peers.json"
REFERENCES = record.FOLDER / "run_time_references.json"

TOLERANCES = [10.0**-k for k in range(3, 16)]
QUICK_TOLERANCES = [1e-4, 1e-7, 1e-10, 1e-13]
ALL = [name for group in scenes.SETS.values() for name in group]
PEERS = ("tam570, compiled", "tam570, prepared", "heyoka", "CyRK", "SciPy DOP853")
QUICK_SCENES = ["ballistics", "hanging spring", "braking car"]
TARGETS = (1e-6, 1e-9, 1e-12)
LONGEST = 1.0  # s of one run; a slower method is not run at finer tolerances
REPEATED = 0.02  # s of processor time spent on the repeats of a run
EPS = 2.0**-52


def references(names):
    """Return the end state of each scene, strings of 30 digits; compute those not stored for the same scene."""
    known_states = json.loads(REFERENCES.read_text()) if REFERENCES.exists() else {}
    for name in tqdm(names, desc="references", disable=None):
        rhs, start, parameters, end = scenes.scene(name)
        request = repr((rhs.__name__, start, parameters, end))
        if known_states.get(name, {}).get("asked") != request:
            state = extrapolation.end_state((rhs, start, parameters, end))
            known_states[name] = {"asked": request, "state": [mpmath.nstr(x, 30) for x in state]}
            REFERENCES.write_text(json.dumps(known_states, indent=1))
    return {name: known_states[name]["state"] for name in names}


def error(state, reference):
    """Return the largest component of the error over the largest of the state."""
    with mpmath.workdps(30):
        exact = [mpmath.mpf(x) for x in reference]
        wrong = max(abs(mpmath.mpf(float(x)) - y) for x, y in zip(state, exact, strict=True))
        return float(wrong / max(map(abs, exact)))


def condition(scene):
    """Return the largest relative change of the end state over that of a component of the start, or of the duration."""
    rhs, start, parameters, end = scene
    solve = methods.solve
    largest = np.abs(solve(rhs, np.linspace(0, end, 400), start, parameters=parameters)).max(axis=0)
    final = solve(rhs, (0, end), start, parameters=parameters, rtol=1e-15)[-1]
    changes = [end * np.abs(np.array(rhs(end, final, **parameters), dtype=float)).max()]
    for i in np.flatnonzero(largest):
        near = [np.array(start), np.array(start)]
        near[0][i] += 1e-6 * largest[i]
        near[1][i] -= 1e-6 * largest[i]
        up, down = (solve(rhs, (0, end), y, parameters=parameters, rtol=1e-12)[-1] for y in near)
        changes.append(np.abs(up - down).max() / 2e-6)
    return float(max(changes) / np.abs(final).max())


def measured(method, scene, tolerance, reference):
    """Return (seconds, error, seconds of preparation and first run) at a tolerance; None if the method fails."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # odeint and LSODA warn at tolerances below their rounding
            began = time.process_time()
            run = methods.METHODS[method](scene, tolerance)
            state = run()
            first = time.process_time() - began
            return (_least_time(run), error(state, reference), first) if np.isfinite(state).all() else None
    except (ValueError, ArithmeticError, RuntimeError, NotImplementedError, TypeError):
        return None


def _least_time(run):
    """Return the least time of a run, s; short runs are timed in groups of at least 1 ms."""
    together, times, began = 1, [], time.process_time()
    while time.process_time() - began < REPEATED or len(times) < 3:
        start = time.process_time()
        for _ in range(together):
            run()
        passed = time.process_time() - start
        if passed < 1e-3 and not times:
            together *= 2
            continue
        times.append(passed / together)
        if times[-1] > 0.1:
            break
    return min(times)


def curves(name, tolerances, reference, names):
    """Return {method: [[tolerance, seconds, error], ...]}, run in turn, and {method: seconds of compiling}."""
    scene, points, done, compiling = scenes.scene(name), {method: [] for method in names}, set(), {}
    for tolerance in tolerances:
        for method in (m for m in names if m not in done):
            result = measured(method, scene, tolerance, reference)
            if result is not None:
                seconds, wrong, first = result
                points[method].append([tolerance, seconds, wrong])
                compiling.setdefault(method, max(0.0, first - seconds))
                if seconds > LONGEST:
                    done.add(method)
    return points, compiling


def cold_times(name, curves_of):
    """Return {method: seconds} of a new process to its first result, if it reaches 1e-9; (first): no code on disk."""
    times = {}
    for method, curve in curves_of.items():
        tolerance = next((tol for tol, _, e in curve if e <= 1e-9), None)
        if tolerance is None:
            continue
        times[method] = min(_process(name, method, tolerance) for _ in range(2))
        if method in ("tam570, compiled", "tam570, auto"):
            with tempfile.TemporaryDirectory() as empty:
                times[f"{method} (first)"] = _process(name, method, tolerance, XDG_CACHE_HOME=empty)
    return times


def _process(name, method, tolerance, **environment):
    """Return the processor time of a new process up to its first result, s."""
    code = (
        f"import sys; sys.path.insert(0, {str(Path(__file__).parent)!r}); from run_time import methods, scenes; "
        f"methods.METHODS[{method!r}](scenes.scene({name!r}), {tolerance!r})()"
    )
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    subprocess.run([sys.executable, "-c", code], env={**os.environ, **environment}, check=True, capture_output=True)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def report(results):
    """Print the tables."""
    for target in TARGETS:
        print(f"\ntime to an error of {target:g}, SciPy DOP853 = 1")
        for method, row in results["ratios"][f"{target:g}"].items():
            print(f"  {method:22} median {row['median']:8.4f}   worst {row['worst']:8.4f}   scenes {row['scenes']}")
    print("\ncompiling, processor s: median, largest")
    for method, (median, largest) in results["compiling"].items():
        print(f"  {method:22} {median:8.3f} {largest:8.3f}")
    for group, rows in ((group, rows) for group, rows in results["against"].items() if rows):
        print(f"\nover a peer at the same error: {group}")
        for ours, peer, target, row in rows:
            print(
                f"  {ours:18} {peer:14} {target:g}  median {row[0]:7.2f}  worst {row[1]:7.2f} ({row[2]})  of {row[3]}"
            )
    print("\nsmallest error over condition number times eps")
    for name, scene in results["scenes"].items():
        floor = scene["condition"] * EPS
        best = {m: min(e for _, _, e in curve) / floor for m, curve in scene["curves"].items() if curve}
        print(f"  {name:22} {floor:.1e}  " + ", ".join(f"{m} {x:.2g}" for m, x in best.items()))
    for name, scene in results["scenes"].items():
        if scene.get("cold"):
            print(f"\nfirst result from a cold process, s: {name}")
            print("  " + ", ".join(f"{m} {s:.2f}" for m, s in sorted(scene["cold"].items(), key=lambda item: item[1])))


def measure(names, tolerances, cold, keep, results, requested=()):
    """Measure the scenes and return the results; call `keep` with them after every scene, in case the run is stopped.

    results : scenes measured before, to which those measured now are added
    """
    exact = references(names)
    installed = [method for method in requested or methods.METHODS if methods.available(method)]
    for name in tqdm(names, desc="scenes"):
        measured_curves, compiling = curves(name, tolerances, exact[name], installed)  # before anything is compiled
        scene = {"curves": measured_curves, "compiling": compiling, "condition": condition(scenes.scene(name))}
        scene["cold"] = cold_times(name, scene["curves"]) if cold and name in QUICK_SCENES else {}
        results[name] = scene
        keep(summary(results))
    return summary(results)


def summary(results):
    return {**comparison.tables(results, TARGETS, scenes.SETS), "scenes": results}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="three scenes, four tolerances, no cold processes")
    parser.add_argument("--peers", action="store_true", help="compiled methods alone, on all problems")
    parser.add_argument("--scenes", nargs="+", choices=ALL, metavar="NAME", help="these alone; --out keeps its others")
    parser.add_argument("--sets", nargs="+", choices=scenes.SETS, help="the scenes of these sets alone")
    parser.add_argument("--methods", nargs="+", choices=methods.METHODS, help="these alone")
    parser.add_argument("--tolerances", nargs="+", type=float, help="these alone")
    parser.add_argument("--no-cold", action="store_true", help="no cold processes")
    parser.add_argument("--out", type=Path, help="JSON to write, also for a part of the scenes or methods")
    options = parser.parse_args()
    sets = [name for group in options.sets or () for name in scenes.SETS[group]]
    usual = [*scenes.SETS["scenes"], *(scenes.OTHERS if options.peers else ())]
    names = options.scenes or sets or (QUICK_SCENES if options.quick else usual)
    tolerances = options.tolerances or (QUICK_TOLERANCES if options.quick else TOLERANCES)
    is_part = options.scenes or sets or options.methods or options.tolerances
    is_complete = not (options.quick or is_part or options.no_cold)
    out = options.out or ((PEERS_OUTPUT if options.peers else OUTPUT) if is_complete else None)
    keep = (lambda results: record.write(out, **results)) if out else (lambda results: None)
    earlier = record.read(out).get("scenes", {}) if (options.scenes or sets) and out else {}
    requested = options.methods or (PEERS if options.peers else ())
    cold = not (options.quick or options.no_cold or options.peers)
    with tempfile.TemporaryDirectory() as empty:  # so that compiling is measured
        os.environ["XDG_CACHE_HOME"] = empty
        results = measure(names, tolerances, cold, keep, earlier, requested)
    report(results)
    if out:
        print(f"\nwritten: {out}")


if __name__ == "__main__":
    main()
