"""What a machine can see of the voice: sentences of 25 words at most, and none of the turns that CONTRIBUTING names.

Looked at is what students and instructors read: problems, hints, lines of checks, known mistakes, helps, errors.
"""

import ast
import re
import tomllib

import pytest

from tam570_grader.writing import assignments

COURSE = assignments.find()
LONGEST = 25  # words
TURNS = {
    "is no X": re.compile(r"(?<!here )\b(is|are) no (?!more\b|longer\b)", re.IGNORECASE),
    "taken for": re.compile(r"\btaken for\b"),
    "that of": re.compile(r"\b(that|those) of\b"),
    "there is none of": re.compile(r"\b(is|are) none\b"),
    "a predicate at the front": re.compile(
        r"^(Allowed|Asked|Given|Known|Left out|Missing|Needed|Right|Tested|Unknown|Wrong) (is|are|was|were)\b"
    ),
}
CODE = re.compile(r"^ {4}.*?$|^```.*?^```$|^% .*?$", re.MULTILINE | re.DOTALL)
WORD = re.compile(r"[^\W\d_]{2,}|\b[aAI]\b")
END = re.compile(r"(?<=[.?!])[)\"*]*\s+|(?<=\)) · ")
READ = ("help", "description", "epilog", "hint", "says")  # arguments whose text people read


def wrong(text):
    """What is wrong with the voice of a text, a line for each sentence."""
    for sentence in END.split(" ".join(re.sub(r"`[^`]*`", "code", text).split())):
        words = len(WORD.findall(sentence))
        turns = [name for name, turn in TURNS.items() if turn.search(sentence)]
        if turns or words > LONGEST:
            yield f"{', '.join(turns) or f'{words} words'}: {sentence}"


def paragraphs(markdown):
    """Paragraphs, items, headings and cells of a page, without its code."""
    for block in re.split(r"\n\s*\n|\n(?=[-|>#])", CODE.sub("", markdown)):
        cells = re.split(r"\||; ", block) if block.startswith("|") else [block]
        yield from (cell.lstrip("-># ") for cell in cells)


def spoken(node):
    """The text of an expression, where it is one; a value in it counts as a word."""
    if isinstance(node, ast.Constant) and isinstance(node.value, str):
        return node.value
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else "it" for part in node.values)
    return ""


def messages(source):
    """What a module says when it raises, and in its helps and hints."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call):
            yield from map(spoken, node.exc.args)
        elif isinstance(node, ast.keyword) and node.arg in READ:
            yield spoken(node.value)
        elif isinstance(node, ast.Call) and ast.unparse(node.func) == "expect_that":
            yield from map(spoken, node.args[1:])


def lines_of_checks(source):
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef) and any("check" in ast.unparse(one) for one in node.decorator_list):
            yield ast.get_docstring(node) or ""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and ast.unparse(node.func).split(".")[-1] in ("law", "then"):
            yield spoken(node.args[0])


def texts_of_assignment(slug):
    """(where, text) of all that is said to students about an assignment."""
    released, hidden = COURSE / "assignments" / slug, COURSE / "autograder" / "checks" / slug
    yield from (("README.md", one) for one in paragraphs((released / "README.md").read_text()))
    hints = tomllib.loads((released / "hints.toml").read_text())
    yield from (("hints.toml", hint) for steps in hints.values() for hint in steps)
    for file in sorted(hidden.glob("*.py")):
        source = file.read_text()
        yield from ((file.name, one) for one in [*lines_of_checks(source), *messages(source)])
    for file in sorted(hidden.glob("mistakes/*.py")):
        yield file.stem, (ast.get_docstring(ast.parse(file.read_text())) or "").split("\n\n")[0]


def test_the_voice_of_an_assignment(slug):
    assert not [f"{where}: {said}" for where, text in texts_of_assignment(slug) for said in wrong(text)]


@pytest.mark.parametrize("package", ["shared/tam570", "autograder/tam570_grader"])
def test_the_voice_of_helps_and_errors(package):
    files = sorted((COURSE / package).rglob("*.py"))
    told = [
        (file.relative_to(COURSE), said)
        for file in files
        for text in messages(file.read_text())
        for said in wrong(text)
    ]
    assert files and not told


PAGES = ["README.md", *(f"docs/{one}/*.md" for one in ("students", "instructors", "gallery", "library"))]


@pytest.mark.parametrize("pages", PAGES)
def test_the_voice_of_the_pages(pages):
    files = sorted(COURSE.glob(pages))
    told = [(file.name, said) for file in files for text in paragraphs(file.read_text()) for said in wrong(text)]
    assert files and not told


@pytest.mark.parametrize(
    "text",
    [
        "What is no rotation is refused.",
        "It is taken for rest.",
        "The energy is that of the start.",
        "The letter is none of these.",
        "Unknown are two forces.",
        " ".join(["word"] * 26),
    ],
)
def test_a_turn_is_seen(text):
    assert list(wrong(text))


def test_plain_words_pass():
    assert not list(wrong("There is no ground. " + " ".join(["word"] * 25) + ". The angles are wrong by 2.7 rad."))
