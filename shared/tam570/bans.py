"""What an assignment puts off limits, refused in the same way by `tam570 check` and where work is graded."""

import builtins
import sys
from collections.abc import Iterable
from types import FunctionType, ModuleType
from typing import NoReturn

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # a submission may change the built-in functions

# what a student's file may import besides Python itself, by `check`, in the grader's sandbox and on Gradescope
LIBRARIES = ("numpy", "scipy", "sympy", "mpmath", "matplotlib", "mpl_toolkits", "tam570", "IPython")
HERE, IN_ONE = "in this assignment", "in this function"  # where something is off limits
Change = tuple[object, str, object]  # owner, attribute, value


class Forbidden(ImportError):
    """An import, or a use, of what the assignment puts off limits."""


def must_be_allowed(name: str, parts: Iterable[str] | None, banned: Iterable[str]) -> None:
    """Forbidden where `import name`, or `from name import parts`, takes something of a banned module."""
    wanted = {name, *(f"{name}.{part}" for part in parts or ())}
    for module in banned:
        if any(item == module or item.startswith(f"{module}.") for item in wanted):
            raise Forbidden(f"{module} is off limits {HERE}, even where nothing uses it")


def must_be_there(name: str, slug: str) -> None:
    """ModuleNotFoundError unless a file called `slug` may import this module: what else is installed does not count."""
    top = name.partition(".")[0]
    if top not in {slug, *LIBRARIES} and top not in sys.stdlib_module_names:
        message = f"No module named {name!r}"
        raise ModuleNotFoundError(message, name=name)


class Unusable(ModuleType):
    """Stands in the place of a module, or of a function; its parts can be named and not called.

    what : where it is off limits
    """

    def __init__(self, name: str, what: str) -> None:
        super().__init__(name)
        self._what = what

    def __getattr__(self, attribute: str) -> "Unusable":
        if attribute.startswith("__"):
            raise AttributeError(attribute)
        return Unusable(self.__name__, self._what)

    def __call__(self, *args: object, **kwargs: object) -> NoReturn:
        raise Forbidden(f"{self.__name__} is off limits {self._what}")


def refused(module: ModuleType, name: str, unusable: Unusable) -> list[Change]:
    """Return what to change so that a function of a file cannot be called.

    A plain function gets another body, wherever it is kept; anything else is replaced in the module.
    """
    function = getattr(module, name)
    if not isinstance(function, FunctionType) or function.__globals__ is not vars(module):
        return everywhere(module, function, unusable)
    code = _refusing.__code__.replace(co_freevars=function.__code__.co_freevars)  # as many as its closure has
    return [(function, "__code__", code), (function, "__kwdefaults__", {"_unusable": unusable})]


def _refusing(*args: object, _unusable: Unusable, **kwargs: object) -> NoReturn:
    _unusable()


def everywhere(owner: ModuleType | type, function: object, stand_in: object) -> list[Change]:
    """Return the function replaced by every name that it has in the module or the class."""
    return [(owner, name, stand_in) for name, value in vars(owner).items() if value is function]
