"""Parts that are graded by hand, from `rubric.toml` of an assignment, which students read too.

    [parts.b]
    asks = "your guess before the work, and why the limit has the shape that it has"
    before = "Sketch the path before you compute anything."  # asked above the picture, without points
    prompt = "**My guess:**"  # first words of the answer's cell
    claims = [[0.5, "A guess is written down and stays as it was."], [1.5, "..."]]

The points of a part are the sum over its claims. A claim says what an answer must show, not the answer itself.
"""

from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path

FILE = "rubric.toml"
HEADING = "## Graded by hand"
HOW = "Your teacher gives these points, for each claim that your answer bears out."


@dataclass(frozen=True)
class ManualPart:
    """A part that a teacher grades, claim by claim."""

    asks: str
    claims: tuple[tuple[float, str], ...] = ()  # points, and what an answer shows
    before: str = ""
    prompt: str = "*Your answer*"

    @property
    def points(self) -> float:
        return round(sum(points for points, _ in self.claims), 6)

    @property
    def worth(self) -> str:
        """The points in words: "1 point", "1.5 points"."""
        return f"{self.points:g} point{'s' * (self.points != 1)}"

    @property
    def line(self) -> str:
        """The claims on one line: "0.5 gives a reason; 1 draws it"."""
        return "; ".join(f"{points:g} {claim}" for points, claim in self.claims)


def load_rubric(released: Path) -> dict[str, ManualPart]:
    """Return the parts graded by hand, by letter; raise KeyError or TypeError if the file has another form."""
    path = released / FILE
    if not path.exists():
        return {}
    import tomllib

    parts = tomllib.loads(path.read_text(encoding="utf-8"))["parts"]
    for part in parts.values():
        part["claims"] = tuple((float(points), str(claim)) for points, claim in part.get("claims", ()))
    return {letter: ManualPart(**part) for letter, part in parts.items()}


def rubric_table(part: ManualPart) -> str:
    """Return the claims of a part as a Markdown table."""
    rows = (f"| {points:g} | {claim} |" for points, claim in part.claims)
    return "\n".join(["| points | your answer |", "|---|---|", *rows])


def with_rubric(readme: str, rubric: Mapping[str, ManualPart]) -> str:
    """Return a README with the rubric as its last section."""
    sections = [
        f"**Part ({letter})**, {part.worth}: {part.asks}.\n\n{rubric_table(part)}" for letter, part in rubric.items()
    ]
    heading = [HEADING, HOW] if rubric else []
    return "\n\n".join([without_rubric(readme), *heading, *sections]) + "\n"


def without_rubric(readme: str) -> str:
    """Return a README without its rubric."""
    return readme.partition(HEADING)[0].rstrip()
