"""Compiles the Python engine's loops together with the functions generated for a right-hand side."""

import ast
import ctypes
import inspect
import itertools
from collections.abc import Iterator
from types import ModuleType

from tam570.integrate.compiled.ir import Array, Operand, Value, Writer
from tam570.integrate.compiled.llvm import assembled
from tam570.integrate.compiled.translate import Translator, functions_of

POINTER, WHOLE, NUMBER = ctypes.c_void_p, ctypes.c_int64, ctypes.c_double
KINDS = (POINTER, POINTER, POINTER, WHOLE, POINTER, NUMBER, NUMBER, NUMBER, WHOLE)
HEAD = """define void @{name}(ptr %state, ptr %c, ptr %times, i64 %rows, ptr %out,
    double %origin, double %x, double %longest, i64 %budget) {{
entry:"""


def flat(state: Operand) -> list[Operand]:
    """Return the numbers or values of a state, which is a nested tuple of them."""
    return [x for part in state for x in flat(part)] if isinstance(state, tuple) else [state]


def unflat(numbers: Operand, like: Operand) -> Operand:
    """Undo `flat`: build nested tuples with the structure and number types of `like` from an iterator over numbers."""
    parts = [unflat(numbers, part) if isinstance(part, tuple) else type(part)(next(numbers)) for part in like]
    return type(like)(*parts) if hasattr(like, "_fields") else tuple(parts)


def loop_text(
    loop: ModuleType, generated: str, entry: str, like: Operand, constants: int, handed: tuple[str, ...] = ()
) -> str:
    """Return a module with `entry`, a function of `loop` with arguments (origin, times, out, state, c, x, budget).

    generated : source of the functions that it calls; all are inlined except `rhs`
    like      : a state, for its structure
    handed    : names of functions that `entry` receives as a tuple in its first argument
    """
    functions = {**functions_of(inspect.getsource(loop)), **functions_of(generated)}
    numbers = {name: value for name, value in vars(loop).items() if name.isupper()}
    rhs = functions.pop("rhs", None)
    records = {name: lambda _, *parts: parts for name, value in vars(loop).items() if hasattr(value, "_fields")}
    names = {**numbers, **records, **({"rhs": _call_of_rhs} if rhs else {})}
    writer = Translator(functions, names)
    c = tuple(writer.emit("double", f"load double, ptr {writer.element('%c', i)}") for i in range(constants))
    state = _loaded(writer, like, itertools.count())
    arrays = Array("%times", None, Value("i64", "%rows")), Array("%out", len(like.y))
    origin, x, budget = Value("double", "%origin"), Value("double", "%x"), Value("i64", "%budget")
    longest = [Value("double", "%longest")] if handed else []
    translator = [tuple(writer.globals[name] for name in handed)] if handed else []
    result = writer.call(writer.globals[entry], [*translator, origin, *arrays, state, c, x, *longest, budget])
    for i, value in enumerate(flat(result)):
        writer.do(f"store double {writer.text(value, 'double')}, ptr {writer.element('%state', i)}")
    body = [HEAD.format(name=entry), *writer.allocations, *writer.lines, "  ret void", "}"]
    return assembled([*writer.constants(), *(_rhs_text(rhs, len(like.y), constants) if rhs else []), *body])


def _loaded(writer: Writer, like: Operand, places: Iterator[int]) -> Operand:
    """Load a state with the structure of `like` from memory; places : indices of its numbers."""
    parts: list[Operand] = []
    for part in like:
        if isinstance(part, tuple):
            parts.append(_loaded(writer, part, places))
            continue
        number = writer.emit("double", f"load double, ptr {writer.element('%state', next(places))}")
        is_integer = isinstance(part, int)
        parts.append(writer.emit("i64", f"fptosi double {number.text} to i64") if is_integer else number)
    return tuple(parts)


def _call_of_rhs(writer: Operand, t: Operand, state: tuple[Operand, ...], _: Operand) -> tuple[Value, ...]:
    ir_type = f"{{{', '.join(['double'] * len(state))}}}"
    arguments = ", ".join(f"double {writer.text(x, 'double')}" for x in (t, *state))
    rates = writer.emit(ir_type, f"call {ir_type} @rhs({arguments}, ptr %c)").text
    return tuple(writer.emit("double", f"extractvalue {ir_type} {rates}, {i}") for i in range(len(state)))


def _rhs_text(rhs: ast.FunctionDef, size: int, constants: int) -> list[str]:
    writer = Translator({"rhs": rhs}, {})
    c = tuple(writer.emit("double", f"load double, ptr {writer.element('%c', i)}") for i in range(constants))
    state = tuple(Value("double", f"%s{i}") for i in range(size))
    rates = writer.call(writer.globals["rhs"], [Value("double", "%t"), state, c])
    ir_type, result = f"{{{', '.join(['double'] * size)}}}", "poison"
    for i, rate in enumerate(rates):
        text = writer.text(rate, "double")
        result = writer.emit(ir_type, f"insertvalue {ir_type} {result}, double {text}, {i}").text
    arguments = ", ".join(f"double %s{i}" for i in range(size))
    return [
        f"define internal {ir_type} @rhs(double %t, {arguments}, ptr %c) {{",
        *writer.lines,
        f"  ret {ir_type} {result}",
        "}",
    ]
