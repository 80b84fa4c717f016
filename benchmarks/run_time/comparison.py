"""Summarize curves of run time against error: times to an error, one method over another, compiling."""

import itertools

import numpy as np
from run_time.methods import METHODS

from tam570_grader.results.run_time import time_to

OURS = ("tam570, prepared", "tam570, compiled")
PEERS = ("heyoka", "CyRK")


def tables(scenes, targets, sets):
    """Return all tables; scenes : {scene: its curves and compiling}, sets : {name: scenes}.

    The rows of "against" are our method, the peer, the error, and the result of `against`.
    """
    curves, rows = {name: scene["curves"] for name, scene in scenes.items()}, {}
    for group, members in sets.items():
        part = {name: curves[name] for name in curves if name in members}
        runs = itertools.product(OURS, PEERS, targets)
        compared = [(ours, peer, target, against(part, target, ours, peer)) for ours, peer, target in runs]
        rows[group] = [row for row in compared if row[-1]]
    return {
        "ratios": {f"{target:g}": ratios(curves, target) for target in targets},
        "compiling": compiling(scenes),
        "against": rows,
    }


def _time_to(target, curve):
    """Return seconds to an error of `target`; None if not reached."""
    return time_to(target, [(seconds, error) for _, seconds, error in curve if error > 0])


def compiling(scenes):
    """Return {method: [median, largest]} over the scenes, of seconds by which a first run is longer than a warm one."""
    extra = {}
    for scene in scenes.values():
        for method, seconds in scene["compiling"].items():
            if method != "tam570, prepared":  # it uses the code that "tam570, compiled" made
                extra.setdefault(method, []).append(seconds)
    return {method: [float(np.median(values)), max(values)] for method, values in extra.items()}


def against(curves, target, ours, peer):
    """Return (median, worst, its scene, number) of our time over the peer's at that error; None without scenes."""
    pairs = {name: (_time_to(target, s.get(ours, [])), _time_to(target, s.get(peer, []))) for name, s in curves.items()}
    values = {name: a / b for name, (a, b) in pairs.items() if a and b}
    if not values:
        return None
    worst = max(values, key=values.get)
    return float(np.median(list(values.values()))), values[worst], worst, len(values)


def ratios(curves, target):
    """Return median over the scenes, and the largest, of each method's time over SciPy's DOP853's at that error."""
    rows = {method: against(curves, target, method, "SciPy DOP853") for method in METHODS}
    return {method: {"median": row[0], "worst": row[1], "scenes": row[3]} for method, row in rows.items() if row}
