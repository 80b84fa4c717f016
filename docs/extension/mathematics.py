"""Render formulas as MathML, which browsers draw without scripts.

Browsers ignore `mathvariant="bold"`, so bold letters become the bold letters of Unicode. They set no space around the
name of a function, and too much around a bar.
"""

import re
import unicodedata

from docutils import nodes
from latex2mathml.converter import convert

BOLD = re.compile(r'<m([in]) mathvariant="(bold(?:-italic)?)">(.)</m[in]>')
NAME = r"<mi>(?:(?:arc)?(?:sin|cos|tan)|(?:sin|cos|tan)h|ln)</mi>"
FUNCTION = re.compile(rf"(?<!<msup>){NAME}|<msup>{NAME}<mn>\d</mn></msup>")
THIN = '<mspace width="0.167em"/>'
STYLES = {"bold": "MATHEMATICAL BOLD", "bold-italic": "MATHEMATICAL BOLD ITALIC"}


def setup(app):
    app.add_html_math_renderer("mathml", (_inline, None), (_block, None))
    return {"parallel_read_safe": True}


def mathml(text, display="inline"):
    """Return the MathML of a formula in LaTeX."""
    markup = re.sub("&#x([0-9A-F]+);", _unescaped, convert(text, display=display))
    markup = re.sub(r'<mo(?: stretchy="false")?>[|∣]</mo>', '<mi mathvariant="normal">|</mi>', markup)
    return FUNCTION.sub(_apart, BOLD.sub(_bold, markup))


def _apart(match):
    """Return a function's name with a space to a factor before it, and to an argument without parentheses."""
    before, after = match.string[: match.start()], match.string[match.end() :]
    space = "" if before.endswith(("</mo>", "row>", "<mfrac>", "<math>", "/>")) else THIN
    return space + match[0] + ("" if re.match(r"<mo[^>]*>\(", after) else THIN)


def _unescaped(match):
    return match[0] if (character := chr(int(match[1], 16))) in "<>&" else character


def _bold(match):
    tag, style, letter = match.groups()
    name = unicodedata.name(letter).replace(" LETTER", "").replace("LATIN ", "").replace("GREEK ", "")
    return f'<m{tag} mathvariant="normal">{unicodedata.lookup(f"{STYLES[style]} {name}")}</m{tag}>'


def _inline(writer, node):
    writer.body.append(mathml(node.astext()))
    raise nodes.SkipNode


def _block(writer, node):
    writer.body.append(f'<div class="math" tabindex="0">{mathml(node.astext(), "block")}</div>')
    raise nodes.SkipNode
