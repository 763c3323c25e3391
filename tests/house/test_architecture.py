"""Claims about the house: who imports whom (the table in docs/architecture.md), and that its worked example works."""

from __future__ import annotations

import ast
import re
import subprocess
import sys
from collections.abc import Collection, Iterator
from dataclasses import dataclass
from functools import cache
from graphlib import TopologicalSorter
from pathlib import Path

import pytest

from tests.sources import HOUSE, ROOT, nodes, sources, text, tree
from vecpoly import load
from vecpoly.errors import NoMethodError

PAGE = (ROOT / "docs" / "architecture.md").read_text(encoding="utf-8")
DOORS = ("__init__", "__main__")  # the way in may know everything


@dataclass(frozen=True)
class Import:
    """One import: by which file and part, of what, and whether only inside a function or for type checkers."""

    file: Path
    line: int
    part: str
    target: str
    ours: bool
    late: bool

    def __str__(self) -> str:
        return (
            f"{self.file.relative_to(ROOT)}:{self.line}: {self.part} imports "
            f"{self.target}{' late' if self.late else ''}"
        )


@cache
def imports(path: Path) -> tuple[Import, ...]:
    inside = path.relative_to(HOUSE).with_suffix("").parts
    return tuple(
        Import(path, node.lineno, inside[0], target, ours, late)
        for node, late in statements(tree(text(path)), False)
        for target, ours in targets(node, inside[:-1])
        if target != inside[0] and target not in sys.stdlib_module_names
    )


def statements_in(tree: ast.AST) -> Iterator[ast.AST]:
    """What stands directly in a module, function, class or branch; no import stands in an expression."""
    return (node for node in ast.iter_child_nodes(tree) if not isinstance(node, ast.expr))


def statements(tree: ast.AST, late: bool) -> Iterator[tuple[ast.Import | ast.ImportFrom, bool]]:
    for node in statements_in(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield node, late
        deferred = isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)) or (
            isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test)
        )
        yield from statements(node, late or deferred)


def targets(node: ast.Import | ast.ImportFrom, package: tuple[str, ...]) -> Iterator[tuple[str, bool]]:
    if isinstance(node, ast.ImportFrom) and node.level:
        base = (*package[: len(package) - node.level + 1], *(node.module.split(".") if node.module else ()))
        yield from ((base[0], True),) if base else ((alias.name, True) for alias in node.names)
    else:
        names = [node.module or ""] if isinstance(node, ast.ImportFrom) else [alias.name for alias in node.names]
        for name in names:
            first, _, rest = name.partition(".")
            yield (rest.split(".")[0], True) if first == "vecpoly" else (first, False)


def table() -> dict[str, tuple[frozenset[str], frozenset[str], frozenset[str]]]:
    """Part → what it imports at once, what it imports late (in brackets), which packages it uses at once or late."""
    rows = re.findall(r"^\| (\w+) \|(.*)\|(.*)\|$", PAGE, re.M)
    parsed = {}
    for part, inner, outer in rows:
        if part != "part":
            words = {word.strip() for column in (inner, outer) for word in column.split(",") if word.strip()}
            late = frozenset(word.strip("()") for word in words if word.startswith("("))
            parsed[part] = (
                frozenset(words - {f"({word})" for word in late}),
                late,
                frozenset(outer.replace(" ", "").split(",")),
            )
    return parsed


def test_every_part_of_the_house_is_in_the_table() -> None:
    parts = {path.relative_to(HOUSE).with_suffix("").parts[0] for path in sources()} | {"fonts"}
    assert parts - set(DOORS) == set(table())


def test_nothing_is_imported_against_the_arrows() -> None:
    allowed = table()
    wrong = []
    for one in (one for path in sources() for one in imports(path) if one.part not in DOORS):
        at_once, late, _ = allowed[one.part]
        if one.target not in at_once and not (one.late and one.target in late) and one.target != "__version__":
            wrong.append(str(one))
    assert not wrong, "\n".join(wrong)


def test_the_table_promises_nothing_that_is_not_used() -> None:
    used: dict[str, set[str]] = {}
    for path in sources():
        for one in imports(path):
            used.setdefault(one.part, set()).add(one.target)
    for part, (at_once, late, _) in table().items():
        assert at_once | late == used.get(part, set()) - {"__version__"}, part


def test_the_arrows_go_round_in_no_circle() -> None:
    ours = table()
    tuple(TopologicalSorter({part: at_once & set(ours) for part, (at_once, _, _) in ours.items()}).static_order())


@pytest.mark.parametrize("for_type_checkers", [False, True])
def test_no_module_imports_itself_by_a_detour(for_type_checkers: bool) -> None:
    """Every import counts, at once and inside functions;
    beside those, in the second claim, what only type checkers read."""
    assert not circles(graph(for_type_checkers))


def test_a_circle_is_found_where_there_is_one() -> None:
    assert circles({"a": {"b"}, "b": {"c"}, "c": {"b", "d"}, "d": set()}) == [{"b", "c"}]


Graph = dict[str, set[str]]


def graph(for_type_checkers: bool) -> Graph:
    """Module → the modules that it imports."""
    modules = {_dotted(path): path for path in sources()}
    return {
        name: {
            target
            for node, typing in _all_imports(tree(text(path)), False)
            if for_type_checkers or not typing
            for target in _modules(node, name, path, modules)
        }
        - {name}
        for name, path in modules.items()
        if name != "vecpoly"
    }


def _dotted(path: Path) -> str:
    return ".".join(path.relative_to(ROOT).with_suffix("").parts).removesuffix(".__init__")


def _all_imports(tree: ast.AST, typing: bool) -> Iterator[tuple[ast.Import | ast.ImportFrom, bool]]:
    for node in statements_in(tree):
        if isinstance(node, (ast.Import, ast.ImportFrom)):
            yield node, typing
        yield from _all_imports(
            node, typing or (isinstance(node, ast.If) and "TYPE_CHECKING" in ast.unparse(node.test))
        )


def _modules(node: ast.Import | ast.ImportFrom, name: str, path: Path, modules: Collection[str]) -> set[str]:
    """The modules of the house that an import names: a module of a package, or the package that holds the name."""
    if isinstance(node, ast.Import):
        return {alias.name for alias in node.names if alias.name in modules}
    package = name.split(".")[: len(name.split(".")) - node.level + (path.name == "__init__.py")] if node.level else []
    base = ".".join([*package, *([node.module] if node.module else [])])
    found = {full if (full := f"{base}.{alias.name}") in modules else base for alias in node.names}
    return {one for one in found if one in modules and one != "vecpoly"}


def circles(graph: Graph) -> list[set[str]]:
    """The strongly connected components of more than one module: each reaches the other."""
    reached = {name: _reached(graph, name) for name in graph}
    found = {frozenset(other for other in there if name in reached[other]) for name, there in reached.items()}
    return sorted((set(one) for one in found if one), key=sorted)


def _reached(graph: Graph, name: str) -> set[str]:
    seen, todo = set[str](), list(graph[name])
    while todo:
        if (one := todo.pop()) not in seen:
            seen.add(one)
            todo += graph[one]
    return seen


def test_the_oracle_is_a_stranger_and_no_method_knows_it() -> None:
    graph = table()
    assert graph["oracle"][0] == {"designs", "devices", "errors", "mechanism", "names", "foundation", "words", "numpy"}
    assert graph["plane"][0] == {"numpy"}
    for part in ("methods", "board", "vector", "plane", "algebra", "drawing"):
        assert not reach(part) & {"oracle", "check"}
    assert not reach("drawing") & {"methods", "mechanism", "problem"}


def reach(part: str) -> set[str]:
    graph, seen, todo = table(), set[str](), [part]
    while todo:
        for target in graph.get(todo.pop(), (frozenset(), frozenset(), frozenset()))[0]:
            if target not in seen:
                seen.add(target)
                todo.append(target)
    return seen


def test_files_are_short_and_functions_shorter() -> None:
    long_files = [f"{path}: {n}" for path in sources() if (n := len(text(path).splitlines())) > 250]
    long_functions = [
        f"{path}:{node.lineno} {node.name}: {size}" for path in sources()
        for node in nodes(text(path)) if isinstance(node, ast.FunctionDef)
        and (size := (node.end_lineno or 0) - node.lineno + 1) > 40
    ]  # fmt: skip
    assert not long_files + long_functions


def block(kind: str) -> str:
    found = re.findall(rf"```{kind}\n(.*?)```", PAGE, re.S)
    assert len(found) == 1
    return str(found[0])


TRIAL = """
import sys, types
import vecpoly.methods.kinematics.gears
module = types.ModuleType("vecpoly.methods.kinematics.gears.rgp")
module.__package__ = "vecpoly.methods.kinematics.gears"
sys.modules[module.__name__] = module
exec(compile(open(sys.argv[2], encoding="utf-8").read(), "rgp.py", "exec"), module.__dict__)
import vecpoly
for answer in vecpoly.load(sys.argv[1]).solve(by="exact").answers.values():
    print(answer.key, answer.drawn, answer.exact)
"""


@pytest.fixture
def rolled(tmp_path: Path) -> tuple[Path, Path]:
    problem, method = tmp_path / "inclined-rack.yaml", tmp_path / "rgp.py"
    problem.write_text(block("yaml"), encoding="utf-8")
    method.write_text(block("python"), encoding="utf-8")
    return problem, method


def test_the_worked_example_adds_a_method_that_agrees_with_the_oracle(rolled: tuple[Path, Path]) -> None:
    done = subprocess.run([sys.executable, "-c", TRIAL, *map(str, rolled)], capture_output=True, text=True, check=True)
    answers = {key: (float(drawn), float(exact)) for key, drawn, exact in map(str.split, done.stdout.splitlines())}
    assert {"p_D", "v_B", "v_D", "omega_2"} == set(answers)
    assert answers["v_B"] == pytest.approx((0.4, 0.4), rel=1e-9)
    for drawn, exact in answers.values():
        assert drawn == pytest.approx(exact, rel=1e-9) and abs(exact) > 1e-3


def test_without_the_example_the_refusal_is_the_one_the_page_quotes(rolled: tuple[Path, Path]) -> None:
    with pytest.raises(NoMethodError, match="no graphical method on file draws the position of a group RGP"):
        load(rolled[0]).solve(by="exact")


def test_the_worked_example_is_clean(rolled: tuple[Path, Path]) -> None:
    words = [sys.executable, "-m", "ruff", "check", "--config", str(ROOT / "pyproject.toml"), str(rolled[1])]
    assert subprocess.run(words, capture_output=True, check=False).returncode == 0
