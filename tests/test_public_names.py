"""Every name in an `__all__` exists, and the common utilities say what their functions do."""

import importlib
import inspect

import pytest

from tam570_grader.checks import assignments

COURSE = assignments.find()
SHARED = sorted(
    ".".join(path.relative_to(COURSE / "shared").with_suffix("").parts).removesuffix(".__init__")
    for path in (COURSE / "shared").glob("tam570/**/*.py")
    if path.stem != "__main__" and "templates" not in path.parts
)


@pytest.mark.parametrize("name", SHARED)
def test_what_a_module_exports_is_there_and_documented(name):
    module = importlib.import_module(name)
    exported = getattr(module, "__all__", [])
    assert not [item for item in exported if not hasattr(module, item)]
    functions = [getattr(module, item) for item in exported if inspect.isfunction(getattr(module, item))]
    assert not [item.__name__ for item in functions if not inspect.getdoc(item)]
