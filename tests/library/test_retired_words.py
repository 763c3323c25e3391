"""Words that a textbook does not use are gone from all that is printed: sentences of the code, templates, problems."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from pathlib import Path

from tests.each import each
from tests.sources import ROOT, nodes, sources, text

DATA = {"reproduced"}  # names in JSON, which programs read

ENGLISH = (
    r"hinges and slides", r"\bhigh pairs?\b", r"local freedom", r"compound hinge", r"as many links drive",
    r"[Tt]ake off links", r"take the Assur groups off", r"[Bb]egin far from",
    r"mechanism with lower pairs only", r"[Pp]olygon of the centres", r"\b[Tt]ransferred to \$",
    r"forces[^.]* meet in (?:one|no) point\.", r"\bleans? (?:by|from|to)\b", r"which tells the side",
    r"^line known$", r"\bthrough the point\b", r"[Dd]ynamic-static", r"velocity polygon as a lever",
    r"\bway back\b", r"\bthe work [12]\b", r"mixed train", r"parallel and mixed", r"\breproduced\b",
    r"drawing slip", r"^last digit$", r"turns steadily", r"common tolerances", r"most matters",
    r"Asked in the given", r"whose logarithm", r"\bPrinted answers\b", r"\bThe printed answers\b",
    r"turn of the drive\b", r"(?:the|of|allowed) unevenness", r"coefficient of fluctuation", r"carrier mechanism",
    r"\bthrough the meeting\b(?! point)", r"link \S+, expanded\b",
    r"turns (?:steadily|evenly)", r"^steadily$", r"\beven steps\b", r"gone through", r"(?:sheets|pages) behind",
    r"the turning of link", r"evenly (?:over|about|spread)",
    r"\bmeets? [^.;]{0,60} in \$", r"known at sight", r"goes its stroke", r"stands in its limits",
    r"[Vv]elocities over the radius", r"\bThink\b", r"was misread, shared out", r"either way round",
    r"of the assemblies",
    r"\bif any\)", r"[Ss]ame hand repeated", r"This report finds: ", r"(?<!/s) ↺ ccw", r"(?:are|is|numbers) ours\b",
    r"the (?:figure|guide)[^.]* is lost", r"passes \$\{\}\$ at an offset",
    r"\bover \$[Mφωψ]", r"[Ii]n one round\b", r"\ban oval\b", r"[Aa] four-bar(?! linkage| chain| mechanism| is found)",
    r"[Ss]winging block\b", r"oscillating flat face\b", r"[Ll]evel through", r"\bits other places\b", r"path circle",
    r"height enlarged", r"to no scale", r"Shares of the", r"First static", r"What was asked", r"turns? fully\b",
    r"stand in brackets", r"of an obtuse one", r"judged by its last", r"[Rr]educe (?:all|everything) to",
    r"reduced to (?:its|shaft)",
    r"[Cc]ondition for a crank", r"\bhinged to\b", r"one leg of which", r"\bhoist starts\b", r"to be filled in",
    r"lead a smooth curve", r"compute more places", r"letter the pairs", r"by the angle with the sine", r"^they agree$",
    r"Where the forces act", r"drawn one after the other", r"[Gg]reatest (?:pressure|surplus|speed|shaking|structural)",
    r"(?<!at )[Ll]east (?:radius|number|speed|profile|base circle|transmission)", r"from a (?:large|small) \w+, not of",
    r"linkage found, checked", r"\}: direction of the force", r"Likewise (?:in|for) plane", r": no meeting\.",
    r"^Is it undercut",
    r"^Likewise, from [^.]*: \$", r"^Centre point [^:]*: turned", r"as measured:$", r"^The annulus as it is",
    r"^Only two trial runs", r": round bars;", r"on paper \{\}, less than", r"^Its degree of freedom:",
    r"^Each printed column beside",
    r": static balance\.$", r"^For Freudenstein",
)  # fmt: skip
CHINESE = (
    r"相应一侧", r"在同样的驱动下", r"等值、反向，沿", r"的垂足距", r"性态", r"分子大", r"分母小",
    r"惠氏", r"带宽", r"本题求出", r"各支链中", r"作出它们", r"图形因此", r"[沿上][^，。]{0,6}量取 ?\$", r"或行星轮系",
    r"影像求 \$", r"附图缺失", r"原图已失", r"尺寸为?自拟", r"电子文本", r"本库所取",
    r"带随机误差的手", r"以末位数字为准", r"设计任务", r"(?<!接)[内外]副", r"铰接于槽中", r"（扩大）", r"其作用的范围",
    r"轮心距", r"焊死", r"侧的一点", r"给从动件（", r"同回路同分支", r"此题病态", r"从框内已印出", r"精确求得",
    r"原动件上力偶", r"[；。]过接触点[^，。]*公法线上，", r"法作得曲率", r"换位速度分量",
    r"同样，在平面[^，。]*内：", r"^圆心点[^，。]*：反转", r"短于 \S+ mm：",
)  # fmt: skip


@cache
def told() -> tuple[tuple[str, str], ...]:
    """Every text that can be printed, with its file."""
    sheets = [*sorted((ROOT / "templates").rglob("*.j2")), *sorted((ROOT / "problems").rglob("*.yaml"))]
    texts = [(path.name, said) for path in sources() for said in _strings(path)]
    lines = ((path.name, line) for path in sheets for line in path.read_text("utf-8").splitlines())
    return (*texts, *((name, line) for name, line in lines if not line.startswith("#")))


def _strings(path: Path) -> Iterator[str]:
    """The strings of a module that are no docstrings; of one with blanks, {} stands for what is filled in."""
    found = nodes(text(path))
    said = {id(node.value) for node in found if isinstance(node, ast.Expr)}
    filled = {id(part) for node in found if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in found:
        if isinstance(node, ast.JoinedStr):
            yield "".join(part.value if isinstance(part, ast.Constant) else "{}" for part in node.values)  # type: ignore[misc]
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in said | filled:
            yield node.value


@each([*ENGLISH, *CHINESE])
def test_a_retired_word_is_printed_nowhere(retired: str) -> None:
    word = re.compile(retired)
    found = [(name, text) for name, text in told() if text not in DATA and word.search(text)]
    assert not found, found[:5]


def test_the_search_reads_what_is_printed() -> None:
    texts = {text for _, text in told()}
    assert "速度多边形" in texts and len(texts) > 5000
    assert any("{}" in text and "μ_F" in text for text in texts), "sentences with blanks are read whole"
