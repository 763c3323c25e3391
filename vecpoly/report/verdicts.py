"""What a report says of the answers printed in the book: verdicts in words, each in its box."""

from __future__ import annotations

from collections.abc import Sequence

from ..check.printed.answers import PrintedCheck
from ..check.printed.verdict import Checked, Verdict, is_angle
from ..names import Key
from ..solution import Solution
from ..words import Lang, Words, joined, stopped
from .tables import counted, percent, symbol_of

_HEADINGS = {
    "fail": Words("总评：", "Overall: "),
    "warn": Words("逐项说明：", "Item by item: "),
    "note": Words("关于原书：", "On the textbook solution: "),
    "pass": Words.same(""),
}


_AGREE = Words("原书答案与精确值相符", "The textbook answers agree with the exact values")
_SAME = Words("各计数均与原书答案一致。", "All counts agree with the textbook answers.")
_GAP: dict[Lang, str] = {"zh": "　", "en": "  "}
_AFTER: dict[Lang, str] = {"zh": "", "en": " "}


def verdicts(solution: Solution, checked: PrintedCheck, lang: Lang) -> list[tuple[str, str]]:
    """What is to be said of the printed answers, as (kind of box, text)."""
    said: list[tuple[str, str]] = []
    if checked.whole is not None:
        said.append(("fail", checked.whole.of(lang)))
    for c in checked.answers:
        symbol = symbol_of(c)
        if c.verdict in (Verdict.WRONG, Verdict.ROUNDING) and c.printed.note is not None:
            said.append(
                ("warn", Words(f"${symbol}$：{c.printed.note.zh}", f"${symbol}$: {c.printed.note.en}").of(lang))
            )
    if (
        checked.answers
        and not said
        and all(c.verdict in (Verdict.REPRODUCED, Verdict.ROUNDING) for c in checked.answers)
    ):
        largest = _largest(checked.answers)
        same = all(map(counted, checked.answers))
        said.append(("pass", (_SAME if same else _AGREE + largest + Words("。", ".")).of(lang)))
    said += [("note", e.of(lang)) for e in solution.problem.errata]
    boxes = [
        (kind, _HEADINGS[kind].of(lang), _listed([text for k, text in said if k == kind], lang))
        for kind in dict.fromkeys(k for k, _ in said)
    ]
    if checked.whole is not None:  # one error, which the others tell of: one box
        return [("fail", _GAP[lang].join(f"**{head.strip()}**{_AFTER[lang]}{text}" for _, head, text in boxes))]
    return [(kind, head + text) for kind, head, text in boxes]


def concluded(checked: PrintedCheck, lang: Lang) -> str:
    """How many of the answers agree, and which do not, in a sentence under their table; nothing where all agree, or
    together they cannot be."""
    off = [c for c in checked.answers if c.verdict in (Verdict.OUTLIER, Verdict.WRONG)]
    if not off or checked.whole is not None:
        return ""
    count, right = len(checked.answers), len(checked.answers) - len(off)
    if not right:
        none = Words(f"原书 {count} 个答案均与精确值不符。", f"None of the {count} textbook answers agrees.")
        return none.of(lang) if count > 1 else ""
    parts = [
        joined([Words.same(f"${symbol_of(c)}$") for c in some])
        for verdict in (Verdict.OUTLIER, Verdict.WRONG)
        if (some := [c for c in off if c.verdict is verdict])
    ]
    heads = [v.words for v in (Verdict.OUTLIER, Verdict.WRONG) if any(c.verdict is v for c in off)]
    zh = "；".join(f"{head.zh}：{part.zh}" for head, part in zip(heads, parts, strict=True))
    en = "; ".join(f"{head.en}: {part.en}" for head, part in zip(heads, parts, strict=True))
    return Words(
        f"原书 {count} 个答案中 {right} 个与精确值相符{_largest(checked.answers).zh}；{zh}。",
        f"Of {count} textbook answers {right} agree{_largest(checked.answers).en}; {en}.",
    ).of(lang)


def _largest(answers: Sequence[Checked]) -> Words:
    """The largest deviation of those that agree, of what is no angle; nothing where there is none."""
    agree = [c for c in answers if c.verdict in (Verdict.REPRODUCED, Verdict.ROUNDING) and c.exact]
    right = [c for c in agree if not is_angle(c.printed) and not counted(c)]
    most = max(right, key=lambda c: abs(c.deviation), default=None)
    off = "" if most is None else percent(abs(most.deviation), 2).lstrip("+")
    if most is None or not float(off.removesuffix(" %")):
        return Words("", "")
    name = f"${symbol_of(most)}$"
    return Words(f"（偏差最大的是 {name}，{off}）", f" (the largest deviation is that of {name}, {off})")


def judged_by(answers: Sequence[Checked]) -> dict[str, bool]:
    """What a template may say of how the printed answers are judged."""
    read = [c for c in answers if c.printed.kind == "graphical"]
    return {
        "graphical": any(c.printed.rel is None or c.printed.rel.is_vector for c in answers) or bool(read),
        "angular": any(is_angle(c.printed) for c in read),
        "by_size": any(by_size(c.printed.rel) for c in answers),
    }


def _listed(texts: Sequence[str], lang: Lang) -> str:
    """One text, or several numbered ones run on, each with its full stop."""
    texts = [stopped(text, lang) for text in texts]
    if len(texts) == 1:
        return texts[0]
    return _GAP[lang].join(f"({i}) {text}" for i, text in enumerate(texts, 1))


def by_size(rel: Key | None) -> bool:
    """Whether a printed answer is compared by its size where no sense is printed: a vector, what turns, a moment."""
    return rel is not None and (rel.is_vector or rel.key.startswith(("omega_", "alpha_", "M_")))
