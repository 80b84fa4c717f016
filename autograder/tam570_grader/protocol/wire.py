"""Encode data that cross the sandbox's boundary: msgpack, with float arrays as raw bytes, and nothing executable."""

import builtins
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import chain
from struct import Struct, pack, unpack_from
from typing import Any, TypeAlias

import msgpack
from numpy import array, asarray, frombuffer, generic, ndarray

# a copy: a submission may change the built-ins
__builtins__ = dict(vars(builtins))  # type: ignore[assignment]

Message: TypeAlias = Any  # plain data: numbers, texts, lists and maps of them, float arrays, Foreigns

LENGTH = Struct(">I")  # of a message, sent before it
LONGEST_TEXT = 300  # characters of a label, of an exception's text, of a report on a notebook's cell
FOREIGN, TYPES = 2, {1: "<f8", 3: "<c16"}  # codes of msgpack extensions
LARGEST_ARRAY = 2**24  # bytes; the largest honest result, 1e5 rows of 15 numbers, has 12e6
MOST_ITEMS = 2**20  # items of lists and maps in the replies to one request; a number in a list takes 70 bytes
DEEPEST = 6  # levels of nested lists in a result
MOST_DIMENSIONS = 8  # dimensions of an array; `stacked` adds one
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
    """Placeholder for a value that cannot be sent; only its type, from the fixed list KINDS, is known."""

    type_name: str


class Unreadable(Exception):
    """The bytes are not a valid message."""


def packed(message: Message) -> bytes:
    """Return a message of plain data, float arrays and Foreigns as bytes."""
    return bytes(msgpack.packb(message, default=_extension))


def request(calls: Sequence[bytes], **fields: Message) -> bytes:
    """Return a message with these fields, and with "calls", which are packed already, as bytes."""
    packer = msgpack.Packer(default=_extension, autoreset=False)
    packer.pack_map_header(1 + len(fields))
    for item in chain(*fields.items(), ["calls"]):
        packer.pack(item)
    packer.pack_array_header(len(calls))
    return bytes(packer.bytes() + b"".join(calls))


class ItemBudget:
    """Number of items that lists and maps in messages may still have, as a short message can need much memory."""

    def __init__(self) -> None:
        self.remaining = MOST_ITEMS

    def spend(self, items: Message) -> Message:
        self.remaining -= 1 + len(items)
        if self.remaining < 0:
            raise Unreadable("too many items")
        return items


def unpacked(data: bytes, budget: ItemBudget | None = None) -> Message:
    """Return the message in untrusted bytes, none of which can run; raise Unreadable if they are invalid.

    budget : items that messages may have together (an extension is one item); not needed for messages of the grader
    """
    spend = budget.spend if budget else None

    def extension(code: int, content: bytes) -> ndarray | Foreign:
        if spend:
            spend(())
        return _known(code, content)

    try:
        return msgpack.unpackb(
            data,
            ext_hook=extension,
            list_hook=spend,
            object_hook=spend,
            strict_map_key=True,
            max_ext_len=2 * LARGEST_ARRAY,
            max_array_len=MOST_ITEMS,
            max_map_len=MOST_ITEMS,
        )
    except Exception as error:  # invalid bytes raise many types
        raise Unreadable(str(error)) from None


def portable(value: Message, depth: int = 0) -> Message:
    """Return a student's value as None, bool, float, float or complex array, or list of these.

    Anything else becomes a Foreign.
    """
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
    # numbers of SymPy, mpmath, fractions: numpy.asarray(value, float) accepts them, too
    if hasattr(type(value), "__float__"):
        return _real(value)
    return Foreign("an array of objects" if isinstance(value, ndarray) else type(value).__name__)


def stacked(values: Sequence[Message]) -> ndarray | None:
    """Return portable values as one array if all are floats, or float arrays of one shape; else None."""
    value_type, first = type(values[0]), values[0]
    if any(type(value) is not value_type for value in values):
        return None
    if value_type is ndarray:
        fits = first.dtype.kind == "f" and first.nbytes * len(values) <= LARGEST_ARRAY
        same_form = fits and all(value.dtype == first.dtype and value.shape == first.shape for value in values)
    else:
        same_form = value_type is float
    return array(values) if same_form else None


def _real(number: Message) -> float | Foreign:
    try:
        return 0.0 + float(number)  # the sum is a plain float, not an instance of a subclass
    except Exception:  # an expression with symbols in it
        return Foreign(type(number).__name__)


def _portable_array(numbers: ndarray) -> ndarray | Foreign:
    if numbers.dtype.kind not in "fiubc":
        return Foreign("an array of strings")
    if numbers.nbytes > LARGEST_ARRAY:
        return Foreign("too large an array")
    return numbers.astype(TYPES[3 if numbers.dtype.kind == "c" else 1], copy=False)


def _extension(value: object) -> msgpack.ExtType:
    if isinstance(value, Foreign):
        return msgpack.ExtType(FOREIGN, value.type_name.encode())
    if isinstance(value, ndarray):
        code = 3 if value.dtype.kind == "c" else 1
        header = pack(f"<{1 + value.ndim}q", value.ndim, *value.shape)
        return msgpack.ExtType(code, header + value.astype(TYPES[code]).tobytes())
    if isinstance(value, generic):
        return _extension(asarray(value))
    raise TypeError(f"{type(value).__name__} does not cross the boundary")


def _known(code: int, data: bytes) -> ndarray | Foreign:
    if code == FOREIGN:
        text = data.decode()
        return Foreign(text if text in KINDS else "an object")
    (dimensions,) = unpack_from("<q", data)
    if code not in TYPES or not 0 <= dimensions <= MOST_DIMENSIONS + 1:
        raise Unreadable(f"extension {code}")
    shape = unpack_from(f"<{dimensions}q", data, 8)
    return frombuffer(data, TYPES[code], offset=8 * (1 + dimensions)).reshape(shape)
