"""Compare run time and error of every conversion with scipy.spatial.transform.Rotation.

Both run in turn in one process, and the smallest time of each counts: ratios are reliable even if times vary. By
default SciPy makes the matrices that it reads orthogonal; `assume_valid` omits that and every check.

    python benchmarks/rotations.py            batches of 1, 1e3 and 1e5; writes benchmarks/results/rotations.json
    python benchmarks/rotations.py --quick    1 and 1e3, a second
"""

import argparse
import time
import warnings
from functools import partial
from pathlib import Path

import numpy as np
import record
import scipy
from scipy.spatial.transform import Rotation

from tam570 import rotations

OUTPUT = record.FOLDER / "rotations.json"


def inputs(count):
    """Return the same rotations in every form, without a batch axis if count is 1."""
    rng = np.random.default_rng(570)
    vector = rng.normal(size=(count, 3))
    angle = np.linalg.norm(vector, axis=1)
    rotation = Rotation.from_rotvec(vector)
    forms = {
        "vector": vector,
        "angle": angle,
        "axis": vector / angle[:, None],
        "matrix": rotation.as_matrix(),
        "quaternion": rotation.as_quat(scalar_first=True),
        "scalar last": rotation.as_quat(),  # SciPy's order
        "313": _euler("ZXZ", rotation),
        "312": _euler("ZXY", rotation),
        "noisy": rotation.as_matrix() + 1e-3 * rng.normal(size=(count, 3, 3)),
    }
    return {name: form[0] if count == 1 else form for name, form in forms.items()}


def _euler(sequence, rotation):
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")  # SciPy warns near gimbal lock
        return rotation.as_euler(sequence)


TRUSTED = {"assume_valid": True}  # omits SciPy's checks of a matrix
CONVERSIONS = {  # name -> (ours, SciPy's); from a matrix, SciPy's also takes TRUSTED
    "axis and angle to matrix": (
        lambda x: rotations.matrix_from_axis_angle(x["axis"], x["angle"]),
        lambda x: Rotation.from_rotvec(x["vector"]).as_matrix(),
    ),
    "rotation vector to matrix": (
        lambda x: rotations.exp(x["vector"]),
        lambda x: Rotation.from_rotvec(x["vector"]).as_matrix(),
    ),
    "quaternion to matrix": (
        lambda x: rotations.matrix_from_quaternion(x["quaternion"]),
        lambda x: Rotation.from_quat(x["scalar last"]).as_matrix(),
    ),
    "Euler 313 to matrix": (
        lambda x: rotations.matrix_from_euler("313", x["313"]),
        lambda x: Rotation.from_euler("ZXZ", x["313"]).as_matrix(),
    ),
    "Euler 312 to matrix": (
        lambda x: rotations.matrix_from_euler("312", x["312"]),
        lambda x: Rotation.from_euler("ZXY", x["312"]).as_matrix(),
    ),
    "matrix to axis and angle": (
        lambda x: rotations.axis_angle_from_matrix(x["matrix"]),
        lambda x, **how: Rotation.from_matrix(x["matrix"], **how).as_rotvec(),
    ),
    "matrix to rotation vector": (
        lambda x: rotations.log(x["matrix"]),
        lambda x, **how: Rotation.from_matrix(x["matrix"], **how).as_rotvec(),
    ),
    "matrix to quaternion": (
        lambda x: rotations.quaternion_from_matrix(x["matrix"]),
        lambda x, **how: Rotation.from_matrix(x["matrix"], **how).as_quat(),
    ),
    "matrix to Euler 313": (
        lambda x: rotations.euler_from_matrix("313", x["matrix"]),
        lambda x, **how: _euler("ZXZ", Rotation.from_matrix(x["matrix"], **how)),
    ),
    "matrix to Euler 312": (
        lambda x: rotations.euler_from_matrix("312", x["matrix"]),
        lambda x, **how: _euler("ZXY", Rotation.from_matrix(x["matrix"], **how)),
    ),
    "quaternion product": (
        lambda x: rotations.composition(x["quaternion"], x["quaternion"]),
        lambda x: (Rotation.from_quat(x["scalar last"]) * Rotation.from_quat(x["scalar last"])).as_quat(),
    ),
    "nearest rotation": (
        lambda x: rotations.nearest(x["noisy"]),
        lambda x: Rotation.from_matrix(x["noisy"]).as_matrix(),
    ),
}


def smallest_times(functions, argument, repeats):
    """Return the smallest time of each function, s; they run in turn."""
    best = [np.inf] * len(functions)
    for _ in range(repeats):
        for i, function in enumerate(functions):
            start = time.perf_counter()
            function(argument)
            best[i] = min(best[i], time.perf_counter() - start)
    return best


def timings(counts):
    """Yield a row for each conversion and batch: ns per rotation, and the ratio to SciPy."""
    for count in counts:
        forms, repeats = inputs(count), 30 if count > 1000 else 300
        for name, (our_way, their_way) in CONVERSIONS.items():
            ways = [our_way, their_way, *([partial(their_way, **TRUSTED)] if name.startswith("matrix") else [])]
            ours, scipys, *unchecked = smallest_times(ways, forms, repeats)
            yield {
                "conversion": name,
                "batch": count,
                "ns": 1e9 * ours / count,
                "scipy_ns": 1e9 * scipys / count,
                "ratio": ours / scipys,
                "ratio_unchecked": ours / unchecked[0] if unchecked else None,
            }


def rebuilt(R):
    """Yield name, our round trip from the matrices R, and SciPy's or None."""
    of_valid = Rotation.from_matrix(R, **TRUSTED)
    yield "axis and angle", rotations.matrix_from_axis_angle(*rotations.axis_angle_from_matrix(R)), None
    yield ("rotation vector", rotations.exp(rotations.log(R)), Rotation.from_rotvec(of_valid.as_rotvec()).as_matrix())
    yield ("quaternion", rotations.matrix_from_quaternion(rotations.quaternion_from_matrix(R)), of_valid.as_matrix())
    for ours, scipys in ("313", "ZXZ"), ("312", "ZXY"):
        angles = rotations.euler_from_matrix(ours, R)
        theirs = Rotation.from_euler(scipys, _euler(scipys, of_valid)).as_matrix()
        yield f"Euler {ours}", rotations.matrix_from_euler(ours, angles), theirs


def scenes(count):
    """Yield named sets of matrices: any, near no turn, near half a turn, and near gimbal lock of 313 and 312."""
    rng = np.random.default_rng(571)
    axis, size = rng.normal(size=(count, 3)), 10.0 ** rng.uniform(-14, -3, count)
    first, last = rng.uniform(-np.pi, np.pi, (2, count))
    yield "any", rotations.matrix_from_axis_angle(axis, rng.uniform(0, np.pi, count))
    yield "angle near 0", rotations.matrix_from_axis_angle(axis, size)
    yield "angle near pi", rotations.matrix_from_axis_angle(axis, np.pi - size)
    yield "lock of 313", rotations.matrix_from_euler("313", np.transpose([first, size, last]))
    yield "lock of 312", rotations.matrix_from_euler("312", np.transpose([first, np.pi / 2 - size, last]))


def errors(count):
    """Yield a row for each scene and round trip: the largest error of a matrix entry, in eps."""
    eps = np.finfo(float).eps
    for scene, R in scenes(count):
        for name, ours, scipys in rebuilt(R):
            yield {
                "scene": scene,
                "round_trip": name,
                "eps": np.abs(ours - R).max() / eps,
                "scipy_eps": None if scipys is None else np.abs(scipys - R).max() / eps,
            }


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="no batches of 1e5, fewer matrices")
    parser.add_argument("--output", type=Path, help=f"where the JSON goes (default {OUTPUT.name}, none if quick)")
    options = parser.parse_args()
    versions = {"numpy": np.__version__, "scipy": scipy.__version__}
    result = {"versions": versions, "timings": [], "errors": []}
    for row in timings([1, 1000] if options.quick else [1, 1000, 100_000]):
        result["timings"].append(row)
        unchecked = row["ratio_unchecked"]
        unchecked_text = f"   unchecked {unchecked:5.2f}" if unchecked else ""
        figures = f"{row['ns']:9.1f} ns  SciPy {row['scipy_ns']:9.1f} ns  ratio {row['ratio']:5.2f}"
        print(f"{row['batch']:8d}  {row['conversion']:26s}{figures}{unchecked_text}")
    for row in errors(10_000 if options.quick else 200_000):
        result["errors"].append(row)
        scipys = "" if row["scipy_eps"] is None else f"  SciPy {row['scipy_eps']:9.3g} eps"
        print(f"{row['scene']:14s} {row['round_trip']:16s} {row['eps']:5.2f} eps{scipys}")
    output = options.output or (None if options.quick else OUTPUT)
    if output:
        record.write(output, **result)


if __name__ == "__main__":
    main()
