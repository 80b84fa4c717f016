"""Write pages from the code before Sphinx reads the others: each assignment's problem, the gallery, each lecture."""

import re
import shutil
import subprocess
from pathlib import Path

from scenes import COURSE, film

from tam570.course import assignments, title
from tam570.lectures import catalogue, load
from tam570_grader.lms.systems import SYSTEMS

GREEK = {
    **{"alpha": "α", "beta": "β", "gamma": "γ", "theta": "θ", "lam": "λ"},
    **{"mu": "μ", "pi": "π", "phi": "φ", "psi": "ψ", "omega": "ω"},
}
LETTER = re.compile(rf"\b({'|'.join(GREEK)})(?=\d?\b)")
WIDE = "---\nhtml_theme.sidebar_secondary.remove: true\n---\n"
CHROMIUM = shutil.which("chromium") or shutil.which("google-chrome")  # prints the problems
MARKUP = re.compile(r"([\\*_<>\[\]|$#])")


def setup(app):
    app.connect("builder-inited", _write)
    app.connect("build-finished", _print_problems)
    return {"parallel_read_safe": True}


def _write(app):
    """Write docs/generated; leave unchanged files alone, so that Sphinx does not read them again."""
    folder = Path(app.srcdir, "generated")
    pages = {f"problems/{slug}.md": _problem(slug) for slug in assignments()}
    pages |= {f"lectures/{name}.md": _lecture(lecture) for name, lecture in catalogue().items()}
    pages |= {
        "assignments.md": _gallery(),
        "lectures.md": _lectures(),
        "all_problems.md": _all_problems(),
        "stills.md": _stills(),
        "systems.md": _systems(),
    }
    for old in {*folder.glob("problems/*.md"), *folder.glob("lectures/*.md")} - {folder / name for name in pages}:
        old.unlink()
    for name, text in pages.items():
        file = folder / name
        file.parent.mkdir(parents=True, exist_ok=True)
        if not file.exists() or file.read_text(encoding="utf-8") != text:
            file.write_text(text, encoding="utf-8")
    shutil.copyfile(COURSE / "NOTATION.md", folder / "notation.md")


def _systems():
    """Return the page of learning management systems, with what each exports and imports, from SYSTEMS."""
    parts = ["# Learning management systems\n"]
    for name, system in SYSTEMS.items():
        does = [f"`tam570-grader collect DOWNLOAD --from {name} --roster TABLE`"]
        does += [f"`tam570-grader lms results/ --to {name} --roster TABLE --out scores.csv`"] * bool(system.table)
        does += ["the same with `--pages pages.zip --collected collected.csv` hands pages back"] * bool(system.page)
        times = "The download tells times." if system.has_times else "The download tells no times."
        column = f' `course.toml` names an assignment\'s column: `{name} = "Title or id"`.'
        download = f"Download: {system.export}. {times}{column if system.table and system.table.must_match else ''}"
        commands = "\n".join(f"- {command}" for command in does)
        parts.append(f"## {system.title}\n\n{download}\n\n{commands}\n\nVerified against: {system.verified}\n")
    return "\n".join(parts)


def _problem(slug):
    """Return the page of an assignment: its README, its formulas, how to start, and a link to its scene."""
    readme = f"../../../assignments/{slug}/README.md"
    parts = [
        WIDE,
        f":::{{include}} {readme}\n:relative-images:\n:::\n",
        f"## In symbols\n\n:::{{include}} ../../problems/{slug}.md\n:::\n",
        f"## Start\n\n`tam570 start {slug[:4]}` gives you this problem, the file to fill in, and the visible tests. "
        "Put drawings, plots and words beside your code or into the notebook; `tam570 handin` packs them. "
        f"[The scene](../assignments.md#{slug[:4]}) shows the motion; it shows no code.\n",
    ]
    return "\n".join(parts)


def _all_problems():
    """Return a page of all problems, for printing."""
    includes = [
        f":::{{include}} ../../assignments/{slug}/README.md\n:heading-offset: 1\n:relative-images:\n:::\n"
        for slug in assignments()
    ]
    pdf = '<p><a href="../problems.pdf">The problems as one PDF file</a>.</p>\n' if CHROMIUM else ""
    printing = f"Print this page: each problem begins on a new sheet. {pdf}\n"
    front_matter = "---\nhtml_theme.sidebar_secondary.remove: true\nnosearch: true\n---\n# All problems on one page\n"
    return "\n".join([front_matter, printing, *includes])


def _print_problems(app, exception):
    """Print the page of all problems to problems.pdf, if a browser is installed."""
    if exception or not CHROMIUM or app.builder.format != "html":
        return
    site = Path(app.outdir).resolve()
    options = ["--headless", "--no-sandbox", "--disable-gpu", "--no-pdf-header-footer"]
    page = (site / "generated/all_problems.html").as_uri()
    command = [CHROMIUM, *options, f"--print-to-pdf={site / 'problems.pdf'}", page]
    subprocess.run(command, check=True, capture_output=True, timeout=300)


def _gallery():
    parts = ["# Scenes of the assignments\n\nEach scene is driven by the reference solution. It shows no code.\n"]
    for slug in assignments():
        link = f"[The problem](problems/{slug}.md)"
        parts.append(
            f"({slug[:4]})=\n## {title(slug)}\n\n{film(slug).alt_text}\n\n:::{{scene}} {slug}\n:::\n\n{link}\n"
        )
    return "\n".join(parts)


def _lectures():
    """Return the lectures' entries in the menu, by date."""
    short = {name: re.split("[,:;]", lecture.title)[0] for name, lecture in catalogue().items()}
    tree = "\n".join(f"{words} <generated/lectures/{name}>" for name, words in short.items())
    return f"```{{toctree}}\n:hidden:\n\n{tree}\n```\n"


def _stills():
    """Return what the gallery's front page includes: a still for each scene."""
    tasks = [_card(slug, f"generated/assignments.html#{slug[:4]}", title(slug)) for slug in assignments()]
    shown = [_card(name, f"generated/lectures/{name}.html", lecture.title) for name, lecture in catalogue().items()]
    return f"## Assignments\n\n{_grid(tasks)}\n\n## Lectures\n\n{_grid(shown)}\n"


def _grid(cards):
    return f'```{{raw}} html\n<ul class="stills">\n{"".join(cards)}</ul>\n```'


def _card(name, address, words):
    still = f'<img src="../scenes/{name}.webp" width="800" height="448" loading="lazy" alt="">'
    return f'<li><a href="../{address}">{still}<span>{words}</span></a></li>\n'


def _lecture(lecture):
    """Return the page of a lecture: its scene, its text in docs/lectures, its numbers, its code."""
    module, file = load(lecture.name), f"{lecture.name}.py"
    text = f":::{{include}} ../../lectures/{lecture.name}.md\n:::\n"
    source = f"../../../shared/tam570/lectures/{file}"
    parts = [
        WIDE,
        f"# {lecture.title}\n",
        f"{lecture.date}. Play the scene with `tam570 show {lecture.name}`. Copy the module and change it with "
        f"`tam570 start {lecture.name}`, or download {{download}}`{file} <{source}>`.\n",
        f":::{{scene}} {lecture.name}\n:::\n",
        text,
        *_numbers(module),
        f"## The code\n\n:::{{literalinclude}} {source}\n:language: python\n:::\n",
    ]
    return "\n".join(parts)


def _numbers(module):
    """Yield the state with its units, the conserved quantities, and the parameters."""
    if hasattr(module, "STATE"):
        rows = [
            f"| `{name}` | {unit} | {at:g} |"
            for (name, unit), at in zip(module.STATE.items(), module.START, strict=True)
        ]
        yield "## The state\n\n| name | unit | start of the scene |\n|---|---|---|\n" + "\n".join(rows) + "\n"
    if hasattr(module, "INVARIANTS"):
        firsts = {name: (invariant.__doc__ or "").partition("\n")[0] for name, invariant in module.INVARIANTS.items()}
        laws = [f"- `{name}`: {readable(first)}" for name, first in firsts.items()]
        yield "## The conserved quantities in the code\n\n" + "\n".join(laws) + "\n"
    rows = [f"| `{name}` | `{value!r}` |" for name, value in module.EXAMPLE.items()]
    yield "## The parameters\n\n| name | in the scene |\n|---|---|\n" + "\n".join(rows) + "\n"


def readable(text):
    """Convert a docstring's prose to Markdown: Greek letters, powers and primes as symbols, nothing as markup."""
    parts = re.split(r"(`[^`]*`)", text)
    return "".join(part if part.startswith("`") else _pretty(part) for part in parts)


def _pretty(text):
    text = re.sub(LETTER, lambda match: GREEK[match[1]], text)
    text = re.sub(r"''", "″", text)
    text = re.sub(r"\b(\w)'(?![a-z])", "\\1′", text)
    text = re.sub(
        r"\^(-?\d)(?!\d)", lambda match: match[1].translate(str.maketrans("-0123456789", "⁻⁰¹²³⁴⁵⁶⁷⁸⁹")), text
    )
    return MARKUP.sub(r"\\\1", text)
