"""Text of LLVM's intermediate representation: values, constants, blocks."""

import struct
from dataclasses import dataclass
from typing import Any

__all__ = ["Array", "Slot", "Untranslatable", "Value", "Writer", "number"]


class Untranslatable(TypeError):
    """Python beyond what is translated here."""


@dataclass(frozen=True)
class Value:
    """Something in a register; kind: "double", "i64", "i1" or "ptr"."""

    kind: str
    text: str


@dataclass(frozen=True)
class Array:
    """Doubles at an address; the first of two indices counts rows of `row` doubles."""

    text: str
    row: Any = None
    length: Any = None


@dataclass(frozen=True)
class Slot:
    """The place of a variable in memory, of which LLVM makes registers."""

    kind: str
    text: str


def number(value: float) -> str:
    """A double as LLVM writes it, to the last bit."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


class Writer:
    """The lines of one function: allocations first, then blocks."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.allocations: list[str] = []
        self.count = 0

    def emit(self, kind: str, text: str) -> Value:
        """A new register with what the instruction gives."""
        self.count += 1
        self.lines.append(f"  %v{self.count} = {text}")
        return Value(kind, f"%v{self.count}")

    def do(self, text: str) -> None:
        """An instruction without a result."""
        self.lines.append(f"  {text}")

    def labels(self, *stems: str) -> list[str]:
        self.count += 1
        return [f"{stem}{self.count}" for stem in stems]

    def start(self, label: str) -> None:
        self.lines.append(f"{label}:")

    def jump(self, label: str) -> None:
        self.do(f"br label %{label}")

    def branch(self, test: Any, yes: str, no: str) -> None:
        self.do(f"br i1 {self.text(test, 'i1')}, label %{yes}, label %{no}")

    def text(self, value: Any, kind: str) -> str:
        """The value as an operand of that kind."""
        if not isinstance(value, Value):
            return _literal(value, kind)
        if value.kind == kind:
            return value.text
        change = _CHANGES.get((value.kind, kind))
        if change is None:
            raise Untranslatable(f"a {value.kind} where a {kind} is needed")
        return self.emit(kind, change.format(value.text)).text

    def allocated(self, kind: str) -> Slot:
        self.count += 1
        self.allocations.append(f"  %v{self.count} = alloca {kind}")
        return Slot(kind, f"%v{self.count}")

    def load(self, place: Slot) -> Value:
        return self.emit(place.kind, f"load {place.kind}, ptr {place.text}")

    def store(self, value: Any, place: Slot) -> None:
        self.do(f"store {place.kind} {self.text(value, place.kind)}, ptr {place.text}")

    def element(self, array: str, index: Any) -> str:
        """The address of a double in memory."""
        return self.emit("ptr", f"getelementptr double, ptr {array}, i64 {self.text(index, 'i64')}").text


_CHANGES = {
    ("i64", "double"): "sitofp i64 {} to double",
    ("i1", "double"): "uitofp i1 {} to double",
    ("i1", "i64"): "zext i1 {} to i64",
    ("double", "i1"): "fcmp une double {}, 0.0",
    ("i64", "i1"): "icmp ne i64 {}, 0",
}


def _literal(value: Any, kind: str) -> str:
    if not isinstance(value, int | float):
        raise Untranslatable(f"{value!r} where a {kind} is needed")
    if kind == "double":
        return number(float(value))
    if kind == "i1":
        return "true" if value else "false"
    if isinstance(value, float):
        raise Untranslatable(f"{value!r} where a whole number is needed")
    return str(int(value))
