"""The words for the term of a mutant: the names in it that students know, and the term as they may have written it."""

import ast
import copy
import functools
import re
from collections.abc import Mapping, Set
from dataclasses import dataclass

from tam570_grader.diagnosis.mutants import Edit, Mutant, assigned, mutants_of, names_used, unpacked

LONGEST, WORDS = 24, {"sin", "cos", "tan", "sqrt", "exp", "pi"}  # of a term that is short


@dataclass(frozen=True)
class NamedMutant:
    """A mutant with the words for its term.

    names : {name in the term: the argument of which it is a component, or the name}
    exact : the edit's better words; "" if there are none, or the term is long
    text  : the changed source of the function
    """

    function: str
    edit: Edit
    names: Mapping[str, str]
    exact: str
    text: str

    def term(self, public: Set[str]) -> str:
        """Return the names in the term that are parameters of a function, or components of these."""
        return ", ".join(sorted(name for name, argument in self.names.items() if {name, argument} & public))


@functools.cache
def named_mutants(source: str) -> list[NamedMutant]:
    """Return the mutants of a module with the words for their terms, those of a low rank first."""
    components, quantities_of, documented = unpacked(source), _quantities(source), _documented(source)

    def with_names(mutant: Mutant) -> NamedMutant:
        quantities = quantities_of[mutant.function]
        term = mutant.product if isinstance(mutant.term, ast.Constant | ast.UnaryOp) else mutant.term
        behind = _behind(term, quantities)
        names = (name if name in documented else components.get(name, name) for name in behind)
        arguments = {name: components.get(name, name) for name in names}
        return NamedMutant(mutant.function, mutant.edit, arguments, _exact(mutant, quantities), mutant.text)

    return sorted(map(with_names, mutants_of(source)), key=lambda mutant: mutant.edit.rank)


def _behind(term: ast.expr, quantities: Mapping[str, ast.expr]) -> set[str]:
    """Return the names in a term; if none is a parameter, the names from which they are computed."""
    names = seen = names_used(term)
    while names and not any(isinstance(quantities.get(name), ast.Name) for name in names):
        names = set().union(*(names_used(quantities[name]) for name in names if name in quantities)) - seen
        seen = seen | names
    return names or names_used(term)


def _documented(source: str) -> set[str]:
    """Return the words in the docstrings that students read, except for the article "a"."""
    tree = ast.parse(source)
    documented: list[ast.Module | ast.FunctionDef] = [tree]
    documented += [node for node in tree.body if isinstance(node, ast.FunctionDef) and node.name[0] != "_"]
    return set(re.findall(r"\w+", " ".join(ast.get_docstring(node) or "" for node in documented))) - {"a"}


def _quantities(source: str) -> dict[str, dict[str, ast.expr]]:
    """Return, for each function, the expressions that it assigns to names; a name that students know is its own."""
    functions = [node for node in ast.parse(source).body if isinstance(node, ast.FunctionDef)]
    arguments = {function.name: (*function.args.args, *function.args.kwonlyargs) for function in functions}
    public = _documented(source).union(*({side.arg for side in arguments[f]} for f in arguments if f[0] != "_"))
    public |= {part for part, argument in unpacked(source).items() if argument in public}
    quantities_of: dict[str, dict[str, ast.expr]] = {}
    for function in functions:
        quantities = quantities_of[function.name] = {
            side.arg: ast.Name(side.arg) for side in arguments[function.name] if side.arg in public
        }
        for target, value in assigned(function):
            parts_of = [part for part in getattr(target, "elts", []) if isinstance(part, ast.Name)]
            quantities |= {part.id: ast.Name(part.id) for part in parts_of}
            quantities |= {target.id: value} if isinstance(target, ast.Name) else {}
    return quantities_of


def _exact(mutant: Mutant, quantities: Mapping[str, ast.expr]) -> str:
    """Return the edit's exact words, with the term in parameters and the parameters beside it; "" if it is long."""
    if not mutant.edit.exact or not (term := _in_parameters(mutant.term, quantities)):
        return ""
    names = names_used(mutant.product) - names_used(mutant.term)
    beside = ", ".join(sorted(name for name in names if ast.unparse(quantities.get(name, mutant.product)) == name))
    return mutant.edit.exact.format(term=term, beside=beside and f" beside {beside}")


def _in_parameters(term: ast.expr, quantities: Mapping[str, ast.expr]) -> str:
    """Return a factor as a student may have written it; "" if that is long, or has names that are no parameters."""

    class InParameters(ast.NodeTransformer):
        def visit_Name(self, node: ast.Name) -> ast.expr:
            value = quantities.get(node.id, node)
            return value if isinstance(value, ast.Name) or isinstance(node.ctx, ast.Store) else self.visit(value)

    try:
        text = ast.unparse(InParameters().visit(copy.deepcopy(term)))
    except RecursionError:  # the quantity is computed from itself
        return ""
    words = re.sub(r"\b(math|np|numpy)\.", "", text)
    is_known = set(re.findall(r"[A-Za-z_]\w*", words)) <= quantities.keys() | WORDS
    return words if len(words) <= LONGEST and is_known else ""
