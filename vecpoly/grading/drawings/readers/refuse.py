"""Files that are too large, or no drawings: refused in one sentence each."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING

from ....errors import FaultError, MissingPackageError
from ....limits import DRAWING_UNPACKED
from ....words import Words

if TYPE_CHECKING:
    from xml.etree.ElementTree import Element


def xml(data: bytes, what: str) -> Element:
    """The root of an XML document without entities of its own. Raises FaultError."""
    from defusedxml import DefusedXmlException
    from defusedxml.ElementTree import ParseError, fromstring

    try:
        root: Element = fromstring(data)
    except ParseError as error:
        line, column = error.position
        raise FaultError(
            Words(
                f"{what} 第 {line} 行第 {column + 1} 列不是合法的 XML；请重新导出",
                f"{what}, line {line}, column {column + 1}: not well-formed XML; export it again",
            ),
            code="xml",
            numbers={"line": line, "column": column + 1},
        ) from None
    except (DefusedXmlException, LookupError, ValueError, RecursionError) as error:
        raise FaultError(
            Words(
                f"{what} 含有不允许的 XML 实体或外部引用（{type(error).__name__}）；请另存为普通文件",
                f"{what} has XML entities or references of its own ({type(error).__name__}); save it as a plain file",
            ),
            code="xml-entities",
        ) from None
    return root


def too_large_unpacked(what: str) -> FaultError:
    """Of what grows beyond the limit when it is unpacked."""
    most = DRAWING_UNPACKED // 1_000_000
    return FaultError(
        Words(f"{what} 解压后超过 {most} MB；不予读取", f"{what} unpacks to more than {most} MB; it is not read"),
        code="too-large",
        numbers={"most": DRAWING_UNPACKED},
    )


@contextmanager
def reading(kind: str) -> Iterator[None]:
    """Whatever a library says of a damaged file becomes one refusal; ours pass."""
    try:
        yield
    except FaultError:
        raise
    except ModuleNotFoundError as error:
        raise MissingPackageError(
            Words(
                f"读 {kind} 需要 {error.name}；请 pip install vecpoly[drawings]",
                f"{kind} is read by {error.name}; pip install vecpoly[drawings]",
            )
        ) from None
    except Exception as error:  # a library over a hostile file may raise anything
        told = f"{type(error).__name__}: {error}".splitlines()[0][:120]
        raise FaultError(
            Words(
                f"不能读作 {kind}（{told}）；请用作图软件重新保存",
                f"cannot be read as {kind} ({told}); save it again with the program that drew it",
            ),
            code="unreadable",
        ) from None
