"""What a machine can see of the voice: sentences of 25 words at most, and none of the turns that CONTRIBUTING names.

What students and instructors read is looked at: problems, hints, known mistakes, the lines of checks, and every string
of four words or more in the code that could be a hint, a help or an error, whatever name it is kept under.
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
OF_HINTS = TURNS | {
    "alone for only": re.compile(r"\balone\b"),  # elsewhere it may be right: "Draw the mass alone"
    "wrong by a share of itself": re.compile(r"\d of itself\b"),
}
CODE = re.compile(r"^ {4}.*?$|^```.*?^```$|^% .*?$", re.MULTILINE | re.DOTALL)
WORD = re.compile(r"[^\W\d_]{2,}|\b[aAI]\b")
END = re.compile(r"(?<=[.?!])[)\"*]*\s+|(?<=\)) · ")
A_SENTENCE = 4  # words; what is shorter in code is a name or a key


def wrong(text, forbidden=TURNS):
    """What is wrong with the voice of a text, a line for each sentence."""
    for sentence in END.split(" ".join(re.sub(r"`[^`]*`", "code", text).split())):
        words = len(WORD.findall(sentence))
        turns = [name for name, turn in forbidden.items() if turn.search(sentence)]
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


def unread(node):
    """Parts of a node that are docstrings, or pieces of a formatted string."""
    if isinstance(node, ast.JoinedStr):
        return node.values
    return [node.value] if isinstance(node, ast.Expr) else []


def sentences(source):
    """Every string of a module that may be read: of four words or more, without docstrings and HTML."""
    tree = ast.parse(source)
    parts = {id(part) for node in ast.walk(tree) for part in unread(node)}
    for text in (spoken(node) for node in ast.walk(tree) if id(node) not in parts):
        if len(WORD.findall(text)) >= A_SENTENCE and not text.startswith("<"):
            yield from paragraphs(text)


def drifts(source):
    """What feedback says of the drift of each invariant."""
    for node in ast.walk(ast.parse(source)):
        if isinstance(node, ast.Call) and ast.unparse(node.func) == "Invariant":
            of, unit = map(spoken, node.args[:2])
            yield f"{of} is wrong by 2 {unit}"


def lines_of_checks(source):
    for node in ast.parse(source).body:
        if isinstance(node, ast.FunctionDef) and any("check" in ast.unparse(one) for one in node.decorator_list):
            yield ast.get_docstring(node) or ""


def released(slug):
    """(where, text) of what students read of an assignment before they hand in, and of its checks' lines."""
    folder = COURSE / "assignments" / slug
    yield from (("README.md", one) for one in paragraphs((folder / "README.md").read_text()))
    hints = tomllib.loads((folder / "hints.toml").read_text())
    yield from (("hints.toml", hint) for steps in hints.values() for hint in steps)
    checks = (COURSE / "autograder" / "checks" / slug / "checks.py").read_text()
    yield from (("checks.py", line) for line in lines_of_checks(checks))


def hinted(slug):
    """(where, text) of what feedback says: hints, kinds of input, known mistakes."""
    folder = COURSE / "autograder" / "checks" / slug
    for file in sorted(folder.glob("*.py")):
        source = file.read_text()
        yield from ((file.name, one) for one in [*sentences(source), *drifts(source)])
    for file in sorted(folder.glob("mistakes/*.py")):
        yield file.stem, (ast.get_docstring(ast.parse(file.read_text())) or "").split("\n\n")[0]


def test_the_voice_of_an_assignment(slug):
    assert not [f"{where}: {said}" for where, text in released(slug) for said in wrong(text)]


def test_the_voice_of_hints_and_mistakes(slug):
    assert not [f"{where}: {said}" for where, text in hinted(slug) for said in wrong(text, OF_HINTS)]


@pytest.mark.parametrize("package", ["shared/tam570", "autograder/tam570_grader"])
def test_the_voice_of_helps_and_errors(package):
    files = sorted((COURSE / package).rglob("*.py"))
    told = [
        (file.relative_to(COURSE), said)
        for file in files
        for text in sentences(file.read_text())
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


@pytest.mark.parametrize(
    "source",
    [
        'HINT = "The force is that of the wall."\nlaw("f").agrees(f, hint=HINT)',
        'WORDS = {"at rest": "It is taken for rest."}',
        'def f(n):\n    return f"The letter {n} is none of these."',
    ],
)
def test_a_string_is_seen_whatever_name_it_has(source):
    assert [said for text in sentences(source) for said in wrong(text)]


def test_docstrings_are_for_those_who_read_code():
    assert not list(sentences('def f():\n    """The energy is that of the start."""'))


def test_only_is_said_where_only_is_meant():
    assert list(wrong("It holds for small angles alone.", OF_HINTS)) and not list(wrong("Draw the mass alone."))


def test_plain_words_pass():
    assert not list(wrong("There is no ground. " + " ".join(["word"] * 25) + ". The angles are wrong by 2.7 rad."))
