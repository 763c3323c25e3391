"""The slips: a statement forgotten, a comparison turned round, a sign, a number, an argument, two languages swapped."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

_COMPARED: dict[type[ast.cmpop], type[ast.cmpop]] = {
    ast.Lt: ast.GtE,
    ast.GtE: ast.Lt,
    ast.Gt: ast.LtE,
    ast.LtE: ast.Gt,
    ast.Eq: ast.NotEq,
    ast.NotEq: ast.Eq,
    ast.Is: ast.IsNot,
    ast.IsNot: ast.Is,
    ast.In: ast.NotIn,
    ast.NotIn: ast.In,
}
_ARITHMETIC: dict[type[ast.operator], type[ast.operator]] = {
    ast.Add: ast.Sub,
    ast.Sub: ast.Add,
    ast.Mult: ast.Div,
    ast.Div: ast.Mult,
}
_SYMMETRIC = frozenset({"min", "max", "minimum", "maximum", "dot", "hypot", "isclose", "intersection", "union"})


@dataclass(frozen=True, slots=True, kw_only=True)
class Mutant:
    """One slip in one file: what stood there, what stands there now, the whole text of the spoilt file."""

    path: Path
    line: int
    function: str  # the innermost function by its qualified name; "" outside of all
    kind: str
    before: str
    after: str
    text: str

    def __str__(self) -> str:
        return f"{self.path}:{self.line} {self.kind}: {_short(self.before)} -> {_short(self.after)}"


def mutants(path: Path, source: str) -> Iterator[Mutant]:
    """Every slip that can be made in a file, one at a time; few of them do not compile."""
    lines = source.encode().splitlines(keepends=True)
    for function, node in _nodes(ast.parse(source), ""):
        for kind, part, after in _slips(node):
            before = ast.get_source_segment(source, part) or ""
            text = _spliced(lines, part, after)
            if before != after:
                yield Mutant(
                    path=path, line=part.lineno, function=function, kind=kind, before=before, after=after, text=text
                )


def _nodes(node: ast.AST, function: str) -> Iterator[tuple[str, ast.AST]]:
    """All nodes that run, each with the function it stands in; no annotations, decorators, defaults, assertions,
    imports.

    What runs when the file is imported (defaults, fields of classes) has run before the slip is made.
    """
    match node:
        case ast.FunctionDef():
            inside, children = f"{_inner(function)}{node.name}()", list[ast.AST](node.body)
        case ast.AnnAssign():
            inside, children = function, [node.value] if node.value else []
        case ast.Assert() | ast.Import() | ast.ImportFrom():
            return
        case ast.ClassDef():
            inside, children = f"{_inner(function)}{node.name}", list[ast.AST](node.body)
        case ast.Subscript():
            inside, children = function, [node.value, node.slice]
        case _:
            inside, children = function, list(ast.iter_child_nodes(node))
    for child in children:
        yield inside.removesuffix("()") if inside.endswith("()") else "", child
        yield from _nodes(child, inside)


def _inner(outside: str) -> str:
    """What stands before the name of a function or a class, as in __qualname__."""
    return f"{outside.removesuffix('()')}{'.<locals>' if outside.endswith('()') else ''}." if outside else ""


def _slips(node: ast.AST) -> Iterator[tuple[str, ast.expr | ast.stmt, str]]:
    """(kind, the part that is replaced, what replaces it) of one node."""
    match node:
        case ast.Expr(value=ast.Call() | ast.YieldFrom() | ast.Yield()) | ast.AugAssign() | ast.Raise():
            if not _is_never_reached(node):
                yield "deleted statement", node, "pass"
        case ast.Compare(ops=[op]) if type(op) in _COMPARED:
            yield "turned comparison", node, _with(node, ops=[_COMPARED[type(op)]()])
        case ast.BoolOp():
            yield "and/or", node, _with(node, op=ast.Or() if isinstance(node.op, ast.And) else ast.And())
        case ast.UnaryOp(op=ast.Not() | ast.USub()):
            yield (
                "dropped " + ("not" if isinstance(node.op, ast.Not) else "minus"),
                node,
                f"({ast.unparse(node.operand)})",
            )
        case ast.BinOp(op=op) if type(op) in _ARITHMETIC and not _texts(node):
            yield "swapped arithmetic", node, f"({_with(node, op=_ARITHMETIC[type(op)]())})"
        case ast.IfExp():
            yield "swapped branches", node, f"({_with(node, body=node.orelse, orelse=node.body)})"
        case ast.Constant(value=bool() | int() | float() | complex() as value):
            yield "changed constant", node, repr(_other(value))
        case ast.Call():
            yield from _calls(node)
        case _:
            pass


def _calls(node: ast.Call) -> Iterator[tuple[str, ast.expr, str]]:
    if isinstance(node.func, ast.Name) and node.func.id == "Words" and len(node.args) == 2:
        yield "swapped languages", node, _with(node, args=node.args[::-1])
    elif len(node.args) == 2 and not any(isinstance(arg, ast.Starred) for arg in node.args) and not _of_any_order(node):
        yield "swapped arguments", node, _with(node, args=node.args[::-1])
    for keyword in node.keywords:
        if keyword.arg == "strict":  # of zip: an assertion
            continue
        yield "dropped argument", node, _with(node, keywords=[other for other in node.keywords if other is not keyword])


def _of_any_order(node: ast.Call) -> bool:
    """Whether the arguments may change places, and nothing else changes."""
    return _name(node) in _SYMMETRIC


def _is_never_reached(node: ast.stmt) -> bool:
    """An `assert_never`: read by the type checker alone."""
    return isinstance(node, ast.Expr) and isinstance(node.value, ast.Call) and _name(node.value) == "assert_never"


def _name(node: ast.Call) -> str:
    """Of the function that is called, without the module it is in."""
    return ast.unparse(node.func).rpartition(".")[2]


def _other(value: complex) -> complex:
    return (not value) if isinstance(value, bool) else value + 1 if isinstance(value, int) else 2 * value + (value == 0)


def _texts(node: ast.BinOp) -> bool:
    """Whether texts, lists or tuples are joined: no arithmetic."""
    return any(
        isinstance(side, ast.JoinedStr | ast.List | ast.Tuple | ast.Dict)
        or (isinstance(side, ast.Constant) and isinstance(side.value, str))
        for side in (node.left, node.right)
    )


def _with(node: ast.expr, **fields: object) -> str:
    """The node's text with some of its parts exchanged."""
    return ast.unparse(type(node)(**{**dict(ast.iter_fields(node)), **fields}))


def _spliced(lines: list[bytes], part: ast.expr | ast.stmt, after: str) -> str:
    first, last = part.lineno - 1, (part.end_lineno or part.lineno) - 1
    head, tail = lines[first][: part.col_offset], lines[last][part.end_col_offset or 0 :]
    return b"".join([*lines[:first], head + after.encode() + tail, *lines[last + 1 :]]).decode()


def compiles(text: str) -> bool:
    """Whether the spoilt file is Python at all."""
    try:
        compile(text, "mutant", "exec")
    except (SyntaxError, ValueError):
        return False
    return True


def _short(text: str) -> str:
    line = " ".join(text.split())
    return line if len(line) <= 90 else f"{line[:87]}..."
