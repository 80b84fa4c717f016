"""Examples: calls of a student's functions beside the right results, as the grader compares them, with other inputs.

`examples.json` of an assignment is made from its hidden checks and a public seed. A known mistake is kept there as a
number for each example that it changes, which tells it without telling how anything is done.
"""

import base64
import json
import zlib
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike

from tam570.values import Function, Json, Numbers

FILE = "examples.json"
SAME = 1e-5  # of a fingerprint's size: mistakes are further apart
FEW = 3  # numbers, which another mistake may have as well
OR_ANOTHER = " Another mistake may give the same few numbers."


@dataclass
class Examples:
    """The examples of an assignment, the fingerprints of its known mistakes, and what a student's functions gave."""

    calls: Sequence[Json]
    mistakes: Sequence[Json]
    results: dict[int, Numbers] = field(default_factory=dict)

    def module(self, slug: str) -> str:
        """Return a module of tests, one for each example."""
        lines = [f"import {slug} as hw"]
        for number, call in enumerate(self.calls):
            lines += [
                f"def test_{call['function']}_example_{number}():",
                f"    _example(hw.{call['function']}, {number})",
            ]
        return "\n".join(lines) + "\n"

    def run(self, function: Function, number: int) -> None:
        """Call the function as the example does; AssertionError where a result is not right."""
        from tam570.checking.visible import difference

        call = self.calls[number]
        refused = any(comparison.get("raises") for comparison in call["compare"])
        try:
            result = function(*map(_argument, call["args"]), **{k: _argument(v) for k, v in call["kwargs"].items()})
        except ValueError:
            if refused:
                return
            raise
        if refused:
            raise AssertionError(f"It raises no ValueError for {call['label']}, and it should.")
        self.results[number] = result
        for comparison in call["compare"]:
            actual, expected = part(result, comparison), array_of(comparison["expected"])
            scale = array_of(comparison["scale"])
            if actual.shape != expected.shape and expected.ndim:
                raise AssertionError(f"Your code gives an array of shape {actual.shape}; {expected.shape} is right.")
            error = float(np.max(np.where(actual == expected, 0.0, np.abs(actual - expected)) / scale, initial=0.0))
            if not error <= comparison["tolerance"]:
                label = f" for {call['label']}" if call["label"] else ""
                quantity = comparison["quantity"] or "the result"
                sentence = f"{quantity[:1].upper()}{quantity[1:]} is wrong{label}."
                raise AssertionError(f"{sentence} {difference(actual, expected)}")

    def mistake(self, function: str) -> str | None:
        """Return the one known mistake of a function that gives the student's results; None where others may.

        These are others of the list, and all that gives a few numbers of which some are zero by a symmetry.
        """
        results = {n: result for n, result in self.results.items() if self.calls[n]["function"] == function}
        of_it = [mistake for mistake in self.mistakes if mistake["function"] == function]
        agreeing = [mistake for mistake in of_it if results and self._agrees(mistake["results"], results)]
        if len({mistake["message"] for mistake in agreeing}) != 1:
            return None
        wrong = [comparison for number in agreeing[0]["results"] for comparison in self.calls[int(number)]["compare"]]
        expected = np.concatenate([np.ravel(array_of(comparison["expected"])) for comparison in wrong])
        if expected.size <= FEW and not expected.all():
            return None
        return opened(agreeing[0]["message"]) + ("" if expected.size > FEW else OR_ANOTHER)

    def _agrees(self, wrong: Mapping[str, Sequence[float] | None], results: Mapping[int, Numbers]) -> bool:
        """Return whether every example has the mistake's numbers, and in one of them these are not the right ones.

        wrong : its fingerprints in the examples that it changes; None where it has no result
        """
        is_wrong = False
        for number, result in results.items():
            comparisons = self.calls[number]["compare"]
            fingerprints = [fingerprint(array_of(comparison["expected"])) for comparison in comparisons]
            numbers = wrong.get(str(number), fingerprints)
            if numbers is None:
                return False
            for comparison, expected, unchanged in zip(comparisons, numbers, fingerprints, strict=True):
                size = 1e-12 + abs(expected) + float(np.max(np.abs(array_of(comparison["expected"])), initial=0.0))
                if not abs(fingerprint(part(result, comparison)) - expected) <= SAME * size:
                    return False
                is_wrong = is_wrong or abs(expected - unchanged) > SAME * size
        return is_wrong


def load_examples(folder: Path) -> Examples | None:
    """Return the examples in the folder of an assignment, where there are some."""
    path = folder / FILE
    if not path.exists():
        return None
    data = json.loads(path.read_text(encoding="utf-8"))
    return Examples(data["examples"], data["mistakes"])


def fingerprint(values: ArrayLike) -> float:
    """Return a number for an array, which differs where the array does: a sum with weights that no symmetry has."""
    flat = np.ravel(np.asarray(values, float))
    return float(flat @ np.cos(1.0 + np.arange(flat.size) * np.sqrt(2.0)))


def closed(message: str) -> str:
    """Return a sentence in a form that nobody reads by accident.

    Those of mistakes that are not yours give answers away.
    """
    return base64.b64encode(zlib.compress(message.encode())).decode()


def opened(message: str) -> str:
    """Return the sentence that `closed` packed."""
    return zlib.decompress(base64.b64decode(message)).decode()


def plain(value: Numbers) -> Numbers:
    """Return an argument or a result as JSON has it; an array is {"array": nested lists}, a tuple {"tuple": [...]}."""
    if isinstance(value, np.ndarray):
        return {"array": [plain(member) for member in value.tolist()]} if value.ndim else plain(value.item())
    if isinstance(value, tuple):
        return {"tuple": [plain(member) for member in value]}
    if isinstance(value, list):
        return [plain(member) for member in value]
    if isinstance(value, np.generic):
        return plain(value.item())
    if isinstance(value, float) and not np.isfinite(value):
        return {"float": str(value)}
    return value


def array_of(value: Numbers) -> Numbers:
    """Return the numbers that `plain` wrote."""
    return np.asarray(_argument(value), float)


def _argument(value: Numbers) -> Numbers:
    if isinstance(value, Mapping):
        ((form, inner),) = value.items()
        if form == "float":
            return float(inner)
        items = [_argument(member) for member in inner]
        return np.array(items, float) if form == "array" else tuple(items)
    return [_argument(member) for member in value] if isinstance(value, list) else value


def part(result: Numbers, comparison: Json) -> Numbers:
    """Return the part of a result that is compared: a member of a tuple, some of its columns."""
    member, columns = comparison["member"], comparison["columns"]
    if columns is not None and isinstance(result, tuple | list) and np.ndim(result[0]) > 1:  # arrays along a motion
        result = np.hstack([np.reshape(np.asarray(array, float), (len(array), -1)) for array in result])
    values = np.asarray(result if member is None else result[member], float)
    return values if columns is None else values[..., columns]
