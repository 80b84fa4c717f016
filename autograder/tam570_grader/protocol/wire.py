"""Data across the sandbox's boundary: msgpack, float arrays as raw bytes, and nothing that could become code."""

import builtins
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from typing import Any

import msgpack
from numpy import array, asarray, ascontiguousarray, frombuffer, generic, ndarray

# What a submission does to the built-in functions must not reach those below.
__builtins__ = dict(vars(builtins))  # type: ignore[assignment]

__all__ = [
    "DEEPEST",
    "LARGEST_ARRAY",
    "Foreign",
    "ItemBudget",
    "Unreadable",
    "packed",
    "portable",
    "request",
    "unpacked",
]

ARRAY, FOREIGN = 1, 2
LARGEST_ARRAY = 2**24  # bytes; the largest honest result, 1e5 rows of 15 numbers, has 12e6
MOST_ITEMS = 2**20  # of lists and maps in the answers to one request; a number in a list takes 70 bytes
DEEPEST = 6  # levels of nested lists in a result
TYPES = ("<f8", "<c16")
KINDS = {
    "dict",
    "set",
    "str",
    "bytes",
    "function",
    "type",
    "generator",
    "an array of objects",
    "an array of strings",
    "too large an array",
    "too deep a list",
}


@dataclass(frozen=True)
class Foreign:
    """A value that does not cross: only what kind it is, out of a fixed list."""

    kind: str


class Unreadable(Exception):
    """The bytes are no message of ours."""


def packed(message: Any) -> bytes:
    """Bytes of a message of plain data, float arrays and Foreigns."""
    return bytes(msgpack.packb(message, default=_extension))


def request(calls: Sequence[bytes], **fields: Any) -> bytes:
    """Bytes of a message of these fields and of "calls", which are packed already."""
    head = msgpack.Packer(default=_extension, autoreset=False)
    head.pack_map_header(1 + len(fields))
    for item in chain(*fields.items(), ["calls"]):
        head.pack(item)
    head.pack_array_header(len(calls))
    return bytes(head.bytes() + b"".join(calls))


class ItemBudget:
    """The items of lists and maps that messages may still have: a short message can ask for much memory."""

    def __init__(self) -> None:
        self.left = MOST_ITEMS

    def taken(self, items: Any) -> Any:
        self.left -= 1 + len(items)
        if self.left < 0:
            raise Unreadable("too many items")
        return items


def unpacked(data: bytes, budget: ItemBudget | None = None) -> Any:
    """The message in the bytes; nothing in it is trusted, and nothing in it can run.

    budget : what the messages that share it may have of items, each extension being one
    """
    budget = budget or ItemBudget()

    def extension(code: int, content: bytes) -> Any:
        budget.taken(())
        return _known(code, content)

    try:
        return msgpack.unpackb(
            data,
            ext_hook=extension,
            list_hook=budget.taken,
            object_hook=budget.taken,
            strict_map_key=True,
            max_ext_len=2 * LARGEST_ARRAY,
            max_array_len=MOST_ITEMS,
            max_map_len=MOST_ITEMS,
        )
    except Exception as error:  # whatever was sent: it is not a message
        raise Unreadable(str(error)) from None


def portable(value: Any, depth: int = 0) -> Any:
    """A student's value as plain numbers, float or complex arrays and lists of these; anything else a Foreign."""
    if value is None or type(value) in (bool, float):
        return value
    if type(value) is int:
        return float(value)
    if depth > DEEPEST:
        return Foreign("too deep a list")
    try:
        numbers = array(value)
    except ValueError:  # ragged
        numbers = None
    if numbers is not None and numbers.dtype.kind != "O":
        return _portable_array(numbers)
    if isinstance(value, list | tuple):
        return [portable(item, depth + 1) for item in value]
    if numbers is not None and numbers.ndim:
        return [portable(item, depth + 1) for item in numbers]
    # of SymPy, mpmath, fractions: numpy.asarray(value, float) takes it too
    if hasattr(type(value), "__float__"):
        return _real(value)
    return Foreign("an array of objects" if isinstance(value, ndarray) else type(value).__name__)


def _real(number: Any) -> Any:
    try:
        return 0.0 + float(number)  # of a subclass of float: a plain one
    except Exception:  # an expression with symbols in it
        return Foreign(type(number).__name__)


def _portable_array(numbers: Any) -> Any:
    if numbers.dtype.kind not in "fiubc":
        return Foreign("an array of strings")
    if numbers.nbytes > LARGEST_ARRAY:
        return Foreign("too large an array")
    return numbers.astype("<c16" if numbers.dtype.kind == "c" else "<f8")


def _extension(value: Any) -> msgpack.ExtType:
    if isinstance(value, Foreign):
        return msgpack.ExtType(FOREIGN, value.kind.encode())
    if isinstance(value, ndarray):
        value = ascontiguousarray(value, value.dtype if value.dtype.str in TYPES else "<f8").reshape(value.shape)
        header = msgpack.packb((value.dtype.str, value.shape))
        return msgpack.ExtType(ARRAY, header + value.tobytes())
    if isinstance(value, generic):
        return _extension(asarray(value))
    raise TypeError(f"{type(value).__name__} does not cross the boundary")


def _known(code: int, data: bytes) -> Any:
    if code == FOREIGN:
        kind = data.decode()
        return Foreign(kind if kind in KINDS else "an object")
    if code != ARRAY:
        raise Unreadable(f"extension {code}")
    header = msgpack.Unpacker()
    header.feed(data[:256])
    kind, shape = header.unpack()
    if kind not in TYPES or len(shape) > 8:
        raise Unreadable("an array's header")
    return frombuffer(data, kind, offset=header.tell()).reshape(shape)
