"""Writes LLVM's intermediate representation as text: values, constants, blocks."""

import operator
import struct
from dataclasses import dataclass
from typing import Any, TypeAlias

Operand: TypeAlias = Any  # a Value, an Array, a Slot, or a compile-time constant: a number or a tuple


@dataclass(frozen=True)
class Value:
    """A register of type "double", "i64", "i1", "ptr" or a vector; "lanes" is the first of consecutive indices."""

    ir_type: str
    text: str


@dataclass(frozen=True)
class Array:
    """Doubles in memory; with two indices, the first selects a row of `row` doubles."""

    text: str
    row: Operand = None
    length: Operand = None


@dataclass(frozen=True)
class Slot:
    """Stack memory of a variable; LLVM turns it into registers."""

    ir_type: str
    text: str


def number(value: float) -> str:
    """Return LLVM's exact literal of a double."""
    return f"0x{struct.unpack('<Q', struct.pack('<d', value))[0]:016X}"


class Writer:
    """The lines of a function: allocations first, then blocks."""

    def __init__(self) -> None:
        self.lines: list[str] = []
        self.allocations: list[str] = []
        self.count = 0

    def emit(self, ir_type: str, text: str) -> Value:
        """Write an instruction and return the register of its result."""
        self.count += 1
        self.lines.append(f"  %v{self.count} = {text}")
        return Value(ir_type, f"%v{self.count}")

    def do(self, text: str) -> None:
        """Write an instruction without a result."""
        self.lines.append(f"  {text}")

    def labels(self, *stems: str) -> list[str]:
        self.count += 1
        return [f"{stem}{self.count}" for stem in stems]

    def start(self, label: str) -> None:
        self.lines.append(f"{label}:")

    def jump(self, label: str) -> None:
        self.do(f"br label %{label}")

    def branch(self, test: Operand, yes: str, no: str) -> None:
        self.do(f"br i1 {self.text(test, 'i1')}, label %{yes}, label %{no}")

    def text(self, value: Operand, ir_type: str) -> str:
        """Return the operand's text, converted to `ir_type`."""
        if ir_type[0] == "<" and not (isinstance(value, Value) and value.ir_type == ir_type):
            return self.spread(value, ir_type)
        if not isinstance(value, Value):
            return _literal(value, ir_type)
        if value.ir_type == ir_type or (value.ir_type, ir_type) == ("lanes", "i64"):
            return value.text
        return self.emit(ir_type, _CHANGES[value.ir_type, ir_type].format(value.text)).text

    def spread(self, value: Operand, vector: str) -> str:
        """Return a vector with the value in every element."""
        count, _, ir_type = vector[1:-1].partition(" x ")
        first = f"insertelement {vector} poison, {ir_type} {self.text(value, ir_type)}, i32 0"
        places = f"<{count} x i32> zeroinitializer"
        return self.emit(
            vector, f"shufflevector {vector} {self.emit(vector, first).text}, {vector} poison, {places}"
        ).text

    def allocated(self, ir_type: str) -> Slot:
        self.count += 1
        self.allocations.append(f"  %v{self.count} = alloca {ir_type}")
        return Slot(ir_type, f"%v{self.count}")

    def load(self, slot: Slot) -> Value:
        return self.emit(slot.ir_type, f"load {slot.ir_type}, ptr {slot.text}")

    def store(self, value: Operand, slot: Slot) -> None:
        self.do(f"store {slot.ir_type} {self.text(value, slot.ir_type)}, ptr {slot.text}")

    def element(self, array: str, index: Operand) -> str:
        """Return the address of element `index` of an array of doubles."""
        return self.emit("ptr", f"getelementptr double, ptr {array}, i64 {self.text(index, 'i64')}").text


_CHANGES = {
    ("i64", "double"): "sitofp i64 {} to double",
    ("i1", "double"): "uitofp i1 {} to double",
    ("i1", "i64"): "zext i1 {} to i64",
    ("double", "i1"): "fcmp une double {}, 0.0",
    ("i64", "i1"): "icmp ne i64 {}, 0",
}


def _literal(value: Operand, ir_type: str) -> str:
    if ir_type == "double":
        return number(float(value))
    if ir_type == "i1":
        return "true" if value else "false"
    return str(operator.index(value))  # TypeError for a float
