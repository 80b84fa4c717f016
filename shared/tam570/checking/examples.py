"""Examples: calls with their right results, compared as in the grader, with other inputs.

`examples.json` of an assignment is made from its hidden checks and a public seed. It stores a known mistake as one
number for each result that the mistake changes, which identifies the mistake and does not reveal a solution.
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
SAME = 1e-5  # relative tolerance of fingerprints; those of mistakes differ by more
FEW = 3  # numbers: another mistake may give the same
OR_ANOTHER = " Another mistake may give the same few numbers."


@dataclass
class Examples:
    """The examples of an assignment, the fingerprints of its known mistakes, and the student's results."""

    calls: Sequence[Json]
    mistakes: Sequence[Json]
    results: dict[int, Numbers] = field(default_factory=dict)

    def module(self, slug: str) -> str:
        """Return the source of a module of tests, one for each example."""
        lines = [f"import {slug} as hw"]
        for number, call in enumerate(self.calls):
            lines += [
                f"def test_{call['function']}_example_{number}():",
                f"    _example(hw.{call['function']}, {number})",
            ]
        return "\n".join(lines) + "\n"

    def run(self, function: Function, number: int) -> None:
        """Call the function as the example does. Raise AssertionError if a result is wrong."""
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
        """Return the message of the only known mistake of a function that gives the student's results, else None.

        None also if the mistake changes only a few numbers, some of them zero: unknown mistakes may give the same.
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
        """Return whether all results agree with the mistake, and at least one is not the right one.

        wrong : the mistake's fingerprints in the examples that it changes; None for an example without result
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
    """Return the examples in the folder of an assignment, or None."""
    path = folder / FILE
    if not path.exists():
        return None
    data = json.loads(path.read_text(encoding="utf-8"))
    return Examples(data["examples"], data["mistakes"])


def fingerprint(values: ArrayLike) -> float:
    """Return a number that differs for different arrays: a sum with weights that have no symmetry."""
    flat = np.ravel(np.asarray(values, float))
    return float(flat @ np.cos(1.0 + np.arange(flat.size) * np.sqrt(2.0)))


def closed(message: str) -> str:
    """Encode a sentence so that nobody reads it by accident.

    Messages about mistakes that a student has not made would give answers away.
    """
    return base64.b64encode(zlib.compress(message.encode())).decode()


def opened(message: str) -> str:
    """Decode a sentence that `closed` encoded."""
    return zlib.decompress(base64.b64decode(message)).decode()


def plain(value: Numbers) -> Numbers:
    """Convert an argument or a result to JSON: an array to {"array": nested lists}, a tuple to {"tuple": [...]}."""
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
    """Return the array of numbers from the JSON of `plain`."""
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
