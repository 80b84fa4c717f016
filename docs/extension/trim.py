"""Remove from the site the style rules that match nothing on any page, and maps and fonts that no page loads.

The theme's style sheet has all of Bootstrap; a page of this site uses a tenth of it.
"""

import re
import shutil
from pathlib import Path

import tinycss2

SHEET = Path("_static/styles/pydata-sphinx-theme.css")
ICONS = re.compile(
    r"fa-|svg-inline--fa|fa[bdlrsk]?$|sd-|docsearch|DocSearch"
)  # icon fonts, and extensions that are not in use
NAME = re.compile(r"[.#]([A-Za-z_][\w-]*)")
NEGATION = re.compile(r":not\([^)]*\)")


def setup(app):
    app.connect("build-finished", _trim)
    return {"parallel_read_safe": True}


def _trim(app, error):
    if error or app.builder.format != "html":
        return
    site = Path(app.outdir)
    words = set()
    for file in [*site.rglob("*.html"), *site.glob("_static/**/*.js")]:
        words.update(re.findall(r"[A-Za-z_][\w-]*", file.read_text(encoding="utf-8", errors="replace")))
    words = {word for word in words if not ICONS.match(word)}
    sheet = site / SHEET
    sheet.write_text(trimmed(sheet.read_text(encoding="utf-8"), words), encoding="utf-8")
    for file in [
        *site.glob("_static/**/*.map"),
        site / "_static/scripts/fontawesome.js",
        site / "_static/webpack-macros.html",
    ]:
        file.unlink(missing_ok=True)
    shutil.rmtree(site / "_static/vendor", ignore_errors=True)


def trimmed(sheet, words):
    """Return the sheet without rules all of whose selectors need a class or an id that is not among the words."""
    rules = tinycss2.parse_stylesheet(sheet, skip_comments=True, skip_whitespace=True)
    return "".join(_kept(rule, words) for rule in rules)


def _kept(rule, words):
    if rule.type == "at-rule" and rule.lower_at_keyword in ("media", "supports") and rule.content is not None:
        body = "".join(_kept(rule, words) for rule in tinycss2.parse_rule_list(rule.content, True, True))
        return f"@{rule.at_keyword}{tinycss2.serialize(rule.prelude)}{{{body}}}" if body else ""
    if rule.type == "at-rule" and rule.lower_at_keyword == "font-face":
        return ""
    if rule.type != "qualified-rule":
        return rule.serialize()
    selectors = tinycss2.serialize(rule.prelude).split(",")
    met = [selector for selector in selectors if words.issuperset(NAME.findall(NEGATION.sub("", selector)))]
    return f"{','.join(met)}{{{tinycss2.serialize(rule.content)}}}" if met else ""
