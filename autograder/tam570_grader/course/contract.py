"""What READMEs and `tam570 check` need of the checks: points of each function, and forms of the results."""

import json
import re
from collections.abc import Mapping

from tam570_grader.checks.assignments import LoadedAssignment
from tam570_grader.checks.returns import form

ROW = re.compile(r"^(\| `(\w+)\(.*?` *\| *)[\d.]+( *\|)", re.MULTILINE)  # a function's row in a README's table


def with_points(readme: str, worth: Mapping[str, float]) -> str:
    """Return the README with the points of each function in its row of the table; `worth` has them by function."""
    return ROW.sub(lambda row: f"{row[1]}{worth.get(row[2], 0.0):g}{row[3]}", readme)


def contract(assignment: LoadedAssignment) -> str:
    """Return contract.json: a line for the form of each function's results, and the names that are off limits."""
    results = [f'  "{name}": {json.dumps(form(returns))}' for name, returns in assignment.returns.items()]
    banned = json.dumps({name: list(modules) for name, modules in assignment.forbidden.items()})
    return '{\n "results": {\n' + ",\n".join(results) + '\n },\n "off_limits": ' + banned + "\n}\n"
