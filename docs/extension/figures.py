"""Make the tables and pictures of the benchmarks' page from `benchmarks/results/`; nothing is measured here.

python docs/extension/figures.py    draws them again, into docs/generated/
"""

import io
import json
import re
from pathlib import Path
from statistics import median

COURSE = Path(__file__).resolve().parents[2]
RESULTS_FOLDER = COURSE / "benchmarks" / "results"
INTO = COURSE / "docs" / "generated" / "figures"
PICTURES = ("run_time_against_error", "run_time_against_peers")
PANELS = 12  # of a picture; of more scenes, every second or third is drawn
COLOURS = {
    "tam570, Python": "#0b62b8",
    "tam570, compiled": "#c2410c",
    "SciPy DOP853": "#444444",
    "odeint": "#0f8a5f",
    "CyRK": "#8b3fc4",
    "heyoka": "#a16c00",
}


def setup(app):
    app.connect("builder-inited", lambda app: _draw())
    return {"parallel_read_safe": True}


def _draw():
    INTO.mkdir(parents=True, exist_ok=True)
    for name, make in TABLES.items():
        results = _results(name)
        origin = f"`{results['command']}` on a shared machine ({results['machine']}), {results['date']}."
        (INTO / f"{name}.md").write_text(f"{make(results)}\n\n{origin}\n", encoding="utf-8")
    for name in PICTURES:
        picture, results = INTO / f"{name}.webp", RESULTS_FOLDER / f"{name}.json"
        if not picture.exists() or results.stat().st_mtime > picture.stat().st_mtime:
            _picture(name)


def _results(name):
    return json.loads((RESULTS_FOLDER / f"{name}.json").read_text())


def _picture(name):
    """Draw run time over error, a panel for each scene; the thick lines are ours."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from PIL import Image

    scenes = _results(name)["scenes"]
    drawn = list(scenes)[:: -(-len(scenes) // PANELS)]
    figure, axes = plt.subplots(-(-len(drawn) // 3), 3, figsize=(11, 2.6 * -(-len(drawn) // 3)), squeeze=False)
    for ax, scene in zip(axes.flat, drawn, strict=False):
        for method, curve in scenes[scene]["curves"].items():
            if curve and method in COLOURS:
                ours = method.startswith("tam570")
                ax.loglog(
                    [max(row[2], 1e-18) for row in curve],
                    [row[1] for row in curve],
                    "o-" if ours else ".--",
                    ms=4,
                    lw=2.0 if ours else 1.0,
                    color=COLOURS[method],
                    label=method,
                )
        ax.set(title=scene, xlim=(10, 1e-18))
        ax.grid(alpha=0.3)
    for ax in axes.flat[len(drawn) :]:
        ax.set_visible(False)
    for ax in axes[:, 0]:
        ax.set_ylabel("run time (s)")
    for ax in axes[-1]:
        ax.set_xlabel("relative error")
    lines = {line.get_label(): line for ax in axes.flat for line in ax.get_lines()}
    figure.tight_layout(rect=(0, 0.05, 1, 1))
    figure.legend(lines.values(), lines.keys(), loc="lower center", ncol=4, frameon=False)
    drawing = io.BytesIO()
    figure.savefig(drawing, dpi=120, bbox_inches="tight")
    plt.close(figure)
    few_colours = Image.open(drawing).convert("RGB").quantize(32, dither=Image.Dither.NONE)  # half the bytes
    few_colours.convert("RGB").save(INTO / f"{name}.webp", lossless=True, method=6)


def _table(heading, rows):
    lines = [heading, ["---"] * len(heading), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def _beside(words, ours, peer):
    """Return a row of a table: our time, that of a peer, s, and their ratio."""
    return [words, f"{1e3 * ours:.0f} ms", f"{1e3 * peer:.0f} ms", f"{peer / ours:.0f}"]


def _grading(results):
    rows = [row for row in results["rows"] if row["submissions"] > 1]
    by = {(row["assignment"], row["grader"].split(",")[0]): row["seconds_each"] for row in rows}
    labels = {"hw08_axis_angle": "hw08, functions of a point", "hw07_double_pendulum": "hw07, simulations"}
    lines = [_beside(words, by[slug, "tam570-grader"], by[slug, "nbgrader"]) for slug, words in labels.items()]
    return _table(["one submission", "tam570-grader, 2 jobs", "nbgrader", "ratio"], lines)


def _size(results):
    lines = []
    for row in results["rows"]:
        seconds = [f"{row[step]['cpu_seconds']:.1f} s" for step in ("resume", "late file", "report")]
        most = max(row[step]["mib"] for step in ("resume", "late file", "report"))
        lines.append([f"{row['submissions']:,}", *seconds, f"{most:.0f} MiB", f"{row['page_mb']:.1f} MB"])
    return _table(["submissions", "resume", "one late file", "report", "most memory", "page"], lines)


def _autograde(results):
    by = {(row["assignment"], row["way"], row["endless_loop"]): row["one_more"] for row in results["rows"]}
    peer = "nbgrader's own, the same notebooks"
    columns = [
        ("hw08", "hw08_axis_angle", "our preprocessors", False),
        ("hw07", "hw07_double_pendulum", "our preprocessors", False),
        ("hw08, 1 of 20 with an endless loop", "hw08_axis_angle", "our preprocessors", True),
        ("the same, 2 s for a call in place of 10", "hw08_axis_angle", "our preprocessors, 2 s a call", True),
    ]
    lines = [_beside(words, by[slug, way, hangs], by[slug, peer, hangs]) for words, slug, way, hangs in columns]
    return _table(["one submission more", "our preprocessors", "nbgrader's own", "ratio"], lines)


def _show(results):
    by = {row["scene"]: row for row in results["rows"]}
    ours, peer = by["hw07_double_pendulum"], by["hw07_double_pendulum, matplotlib HTMLWriter"]
    lines = [
        ["time", f"{ours['seconds']:.2f} s", f"{peer['seconds']:.1f} s"],
        ["size", f"{ours['bytes'] / 1e3:.0f} kB", f"{peer['bytes'] / 1e3:.0f} kB"],
    ]
    return _table(["hw07's scene, 20 s", "tam570", "Matplotlib's HTMLWriter"], lines)


def _rotations(results):
    lines = []
    for batch in sorted({row["batch"] for row in results["timings"]}):
        ratios = [row["ratio"] for row in results["timings"] if row["batch"] == batch and row["ratio"]]
        lines.append([f"{batch}", f"{min(ratios):.2f}", f"{median(ratios):.2f}", f"{max(ratios):.2f}"])
    worst = max(row["eps"] for row in results["errors"])
    scipy = max(row["scipy_eps"] or 0 for row in results["errors"])
    text = _table(["rotations in a call", "smallest", "median", "largest"], lines)
    caption = f"The largest error of a round trip is {worst:.1f} eps here. SciPy's is {scipy:.1g} eps, in gimbal lock."
    return f"{text}\n\n{caption}"


def _ratios(results):
    shown = ["tam570, Python", "tam570, compiled", "odeint", "CyRK", "heyoka"]
    lines = [
        [_power(target), *(f"{rows[name]['median']:.2g} ({rows[name]['worst']:.2g})" for name in shown)]
        for target, rows in results["ratios"].items()
    ]
    return _table(["error", *shown], lines)


def _against(results):
    lines, columns = [], [(ours, peer) for ours in ("prepared", "compiled") for peer in ("CyRK", "heyoka")]
    for problems, rows in results["against"].items():
        cells = {
            (target, ours.removeprefix("tam570, "), peer): f"{middle:.2f} ({worst:.2f}, {scene})"
            for ours, peer, target, (middle, worst, scene, _) in rows
        }
        for target in sorted({target for target, _, _ in cells}, reverse=True):
            lines.append([problems, _power(f"{target:g}"), *(cells[target, *column] for column in columns)])
    heads = [f"{'a prepared run' if ours == 'prepared' else '`solve`'} over {peer}" for ours, peer in columns]
    return _table(["problems", "error", *heads], lines)


def _ensembles(results):
    rows = results["rows"]
    lines = []
    for tolerance in sorted({row["tolerance"] for row in rows}, reverse=True):
        ratios = {row["problem"]: row["ratio"] for row in rows if row["tolerance"] == tolerance}
        worst = max(ratios, key=ratios.get)
        lines.append([_power(f"{tolerance:g}"), f"{median(ratios.values()):.2f}", f"{ratios[worst]:.2f}, {worst}"])
    return _table(["tolerance", "median", "worst"], lines)


def _power(number):
    """Return a power of ten as text, such as 10⁻⁶ for 1e-06."""
    digits = re.sub(r".*e-0*", "", number)
    return "10⁻" + digits.translate(str.maketrans("0123456789", "⁰¹²³⁴⁵⁶⁷⁸⁹"))


TABLES = {
    "grading": _grading,
    "size": _size,
    "autograde": _autograde,
    "show": _show,
    "rotations": _rotations,
    "run_time_against_error": _ratios,
    "run_time_against_peers": _against,
    "ensembles": _ensembles,
}

if __name__ == "__main__":
    _draw()
    print(INTO)
