"""The appendix: all that the problem gives, and the data of all points and links; for templates that print it, the
problem file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...findings.study.study import Study
from ...names import subscripted
from ...words import Words, joined
from ..flow.listing import Listing
from .numbering import TINY, Press
from .one_language import in_one_language
from .results.circling import circling
from .results.tabled import tabled
from .statement import every_datum, in_words

_COLUMNS, _FEW = 11, 25  # of a table; rows that are all told
_RATES = {"p": Words("位置", "position"), "v": Words("速度", "velocity"), "a": Words("加速度", "acceleration")}


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The given data and the tables, these only for what chapter 5 does not show; the listing."""
    press.chapter = "A"
    text = study.problem.text
    return {
        "given": every_datum(study, press),
        "words": in_words(study, press),
        "file": press.objects.add("listing", Listing(in_one_language(text, press.lang))) if text else "",
        "several": "extends:" in text,
        "tables": list(_tables(study, press)),
        "sparse": _every(study) > 1,
    }


def _tables(study: Study, press: Press) -> Iterator[str]:
    """The points that chapter 5 leaves out, two or three to a table; slides and transmission angles."""
    shown = {*study.points, *circling(study)}
    rest = [c.key[2:] for c in study.whole.columns if c.key.startswith("p_") and c.key[2:] not in shown]
    parts, abreast = (("p_{}", "v_{}.abs", "a_{}.abs"), 3) if study.dense else (("p_{}", "v_{}", "a_{}"), 2)
    groups = [rest[i : i + abreast] for i in range(0, len(rest), abreast)]
    last = groups.pop() if groups and len(groups[-1]) < abreast else []  # a small table fills the last page
    yield from (_points(study, press, letters, parts) for letters in groups)
    drive = study.turn.real(study.whole.drive.key)
    slides = [
        c.key
        for c in study.whole.columns
        if c.key.startswith("s_") and not np.allclose(study.turn.real(c.key), drive, equal_nan=True)
    ]
    told = [key for s in slides for key in (s, f"v_{s[2:]}", f"a_{s[2:]}")]
    told += [t.key for t in study.facts.transmissions if not t.is_constant]
    wide = sum(len(study.turn.info(part.format(letter)).parts) for letter in last for part in parts)
    if last and told and len(told) + wide <= _COLUMNS:  # both in one table
        told += [part.format(letter) for letter in last for part in parts]
        last = []
    for i in range(0, len(told), _COLUMNS):
        some = told[i : i + _COLUMNS]
        yield tabled(study, press, some, _title(study, some, bool(slides)), TINY, _every(study))
    if last:
        yield _points(study, press, last, parts)


def _title(study: Study, keys: list[str], slides: bool) -> Words:
    """What a table of these columns shows; slides: whether the tables begin with sliding motions."""
    letters = dict.fromkeys(key.partition(".")[0][2:] for key in keys if key[:2] == "p_")
    kinds = []
    if any(key.startswith("s_") for key in keys):
        kinds.append(Words("移动副的相对运动", "Sliding motions"))
    if any(key.startswith("gamma_") for key in keys):
        kinds.append(Words("传动角", "transmission angles" if slides else "Transmission angles"))
    if letters:
        kinds.append(_motion(study, [*letters], [key for key in keys if key.partition(".")[0][2:] in letters]))
    return Words(
        "、".join(w.zh for w in kinds),
        ", ".join(w.en if not i else w.en[0].lower() + w.en[1:] for i, w in enumerate(kinds)),
    )


def _points(study: Study, press: Press, letters: list[str], parts: tuple[str, ...]) -> str:
    keys = [part.format(letter) for letter in letters for part in parts]
    return tabled(study, press, keys, _motion(study, letters, keys), TINY, _every(study))


def _every(study: Study) -> int:
    """In a long report every other of many positions does."""
    return 2 if study.dense and len(study.rows) > _FEW else 1


def _motion(study: Study, letters: list[str], keys: list[str]) -> Words:
    """What these columns tell of these points: what does not vary has none."""
    varying = [key for key in keys if any(study.varies(part) for part in study.turn.info(key).parts)] or keys
    what = joined([told for rate, told in _RATES.items() if any(key.startswith(f"{rate}_") for key in varying)])
    zh, en = (
        "、".join(f"${subscripted(letter)}$" for letter in letters),
        ", ".join(f"${subscripted(letter)}$" for letter in letters),
    )
    return Words(f"{zh} 点的{what.zh}", f"{what.en.capitalize()} of {en}")
