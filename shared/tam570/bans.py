"""Refuse the modules and functions that an assignment bans, for both `tam570 check` and the grader."""

import builtins
import sys
from collections.abc import Iterable
from types import FunctionType, ModuleType
from typing import NoReturn

__builtins__ = dict(vars(builtins))  # type: ignore[assignment]  # a copy: a submission may change the built-ins

# what a student's file may import besides the standard library, in `check`, the grader's sandbox and Gradescope
LIBRARIES = ("numpy", "scipy", "sympy", "mpmath", "matplotlib", "mpl_toolkits", "tam570", "IPython")
HERE, IN_ONE = "in this assignment", "in this function"  # scope of a ban, as messages name it
Change = tuple[object, str, object]  # owner, attribute, value


class Forbidden(ImportError):
    """Import or call of something that the assignment bans."""


def must_be_allowed(name: str, parts: Iterable[str] | None, banned: Iterable[str]) -> None:
    """Raise Forbidden if `import name` or `from name import parts` imports a banned name or a member of it."""
    wanted = {name, *(f"{name}.{part}" for part in parts or ())}
    for module in banned:
        if any(item == module or item.startswith(f"{module}.") for item in wanted):
            raise Forbidden(f"{module} is off limits {HERE}, even where nothing uses it")


def must_be_there(name: str, slug: str) -> None:
    """Raise ModuleNotFoundError if a file called `slug` may not import a module, even if it is installed here."""
    top = name.partition(".")[0]
    if top not in {slug, *LIBRARIES} and top not in sys.stdlib_module_names:
        message = f"No module named {name!r}"
        raise ModuleNotFoundError(message, name=name)


class Unusable(ModuleType):
    """Placeholder for a banned module or function; a call of it, or of an attribute, raises Forbidden.

    what : the scope of the ban, for the message
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
    """Return the changes after which a call of a module's function raises Forbidden.

    A function defined in the module gets another body, for all references to it; anything else is replaced by name.
    """
    function = getattr(module, name)
    if not isinstance(function, FunctionType) or function.__globals__ is not vars(module):
        return everywhere(module, function, unusable)
    code = _refusing.__code__.replace(co_freevars=function.__code__.co_freevars)  # must match its closure
    return [(function, "__code__", code), (function, "__kwdefaults__", {"_unusable": unusable})]


def _refusing(*args: object, _unusable: Unusable, **kwargs: object) -> NoReturn:
    _unusable()


def everywhere(owner: ModuleType | type, function: object, stand_in: object) -> list[Change]:
    """Return the changes that replace a function under each of its names in a module or class."""
    return [(owner, name, stand_in) for name, value in vars(owner).items() if value is function]
