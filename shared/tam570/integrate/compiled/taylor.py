"""Taylor's method compiled for one right-hand side."""

import ctypes
import inspect
import math
from functools import lru_cache
from typing import Any

from tam570.integrate.compiled import taylor_loop
from tam570.integrate.compiled.ir import Array, Value
from tam570.integrate.compiled.llvm import assembled
from tam570.integrate.compiled.recurrences import Recurrences
from tam570.integrate.compiled.series import HIGHEST, layout, series_text
from tam570.integrate.compiled.translate import Translator, functions_of

__all__ = ["KINDS", "order_for", "taylor_text"]

POINTER, WHOLE, NUMBER = ctypes.c_void_p, ctypes.c_int64, ctypes.c_double
KINDS = (*[POINTER] * 5, WHOLE, POINTER, NUMBER, NUMBER, WHOLE, WHOLE)
HEAD = """define void @advance(ptr %z, ptr %work, ptr %time, ptr %c, ptr %times, i64 %rows, ptr %out,
    double %origin, double %rtol, i64 %order, i64 %budget) {
entry:"""


def order_for(rtol: float) -> int:
    """The order that costs least: Jorba and Zou's, where the steps are e^-2 of the distance to the singularity."""
    return min(HIGHEST, max(4, math.ceil(1 - math.log(rtol) / 2)))


@lru_cache(maxsize=256)
def taylor_text(found: Recurrences) -> str:
    """The module: the series, and the loop over the steps."""
    place = layout(found, 1)
    whole = {"SIZE": len(found.rates), "STRIDE": place.stride, "LANES": 1, "ORDER": "%order"}
    names: dict[str, Any] = {
        **{name: value for name, value in vars(taylor_loop).items() if name.isupper()},
        **{name: Value("i64", str(value)) for name, value in whole.items()},
        **{name: _call_of(name) for name in ("coefficients", "rates")},
    }
    translator = Translator(functions_of(inspect.getsource(taylor_loop)), names)
    translator.flags = " contract"
    given: list[Any] = [Array(f"%{name}") for name in ("z", "work", "time", "c")]
    given += [Array("%times", None, Value("i64", "%rows")), Array("%out", len(found.rates))]
    given += [Value("double", "%origin"), Value("double", "%rtol"), Value("i64", "%budget")]
    translator.called(translator.globals["advance"], given)
    loop = [HEAD, *translator.allocations, *translator.lines, "  ret void", "}"]
    return assembled([*series_text(found, place), *translator.constants(), *loop])


def _call_of(name: str) -> Any:
    def call(writer: Any, work: Array, c: Array, time: Array, order: Value) -> int:
        writer.do(f"call void @{name}(ptr {work.text}, ptr {c.text}, ptr {time.text}, i64 {order.text})")
        return 0

    return call
