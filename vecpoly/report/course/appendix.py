"""The appendix: the data of all points and links that chapter 5 leaves out; for templates that print it, the problem
file."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from ...cycle.columns import slides
from ...findings.study.study import Study
from ...names import subscripted
from ...words import Words, joined
from ..flow.listing import Listing
from .numbering import TINY, Press
from .one_language import in_one_language
from .results.circling import circling, is_trivial
from .results.tabled import halved, tabled

_COLUMNS, _FEW = 11, 25  # of a table; rows that are all told
_RATES = {"p": Words("位置", "position"), "v": Words("速度", "velocity"), "a": Words("加速度", "acceleration")}


def chapter(study: Study, press: Press) -> dict[str, Any]:
    """The tables of what chapter 5 does not show; the listing."""
    press.chapter = "A"
    text, parted, every = study.problem.text, [*_parted(study)], _every(study)
    tables = [tabled(study, press, keys, title, TINY, every) for keys, title in parted]
    called = [press.called[name] if len(tables) > 1 else "" for name in tables]
    halves = [_symmetry(study, keys, name) for (keys, _), name in zip(parted, called, strict=True)]
    return {
        "file": press.objects.add("listing", Listing(in_one_language(text, press.lang))) if text else "",
        "several": "extends:" in text,
        "tables": tables,
        "same": "".join(words.of(press.lang) for words in (_as_points(study), *_reversed(study), *halves)),
        "sparse": every > 1,
    }


def _parted(study: Study) -> Iterator[tuple[list[str], Words]]:
    """The columns of each table with its title: the points that chapter 5 leaves out, two or three to a table; slides
    and transmission angles."""
    shown = {*study.points, *circling(study)}
    rest = [c.key[2:] for c in study.whole.columns if c.key.startswith("p_") and c.key[2:] not in shown]
    parts, abreast = (("p_{}", "v_{}.abs", "a_{}.abs"), 3) if study.dense else (("p_{}", "v_{}", "a_{}"), 2)
    groups = [rest[i : i + abreast] for i in range(0, len(rest), abreast)]
    last = groups.pop() if groups and len(groups[-1]) < abreast else []  # a small table fills the last page
    yield from (_of_points(study, letters, parts) for letters in groups)
    slides = own_slides(study)
    told = [key for s in slides for key in (s, f"v_{s[2:]}", f"a_{s[2:]}")]
    told += [t.key for t in study.facts.transmissions if not t.is_constant]
    wide = sum(len(study.turn.info(part.format(letter)).parts) for letter in last for part in parts)
    if last and told and len(told) + wide <= _COLUMNS:  # both in one table
        told += [part.format(letter) for letter in last for part in parts]
        last = []
    for i in range(0, len(told), _COLUMNS):
        some = told[i : i + _COLUMNS]
        yield some, _title(study, some, bool(slides))
    if last:
        yield _of_points(study, last, parts)


def _symmetry(study: Study, keys: list[str], called: str) -> Words:
    """How the half that a table does not list follows; called: the table, where there are several."""
    half = halved(study, keys, _every(study))
    return half if not half.zh or not called else Words(f"{called}：", f"{called}: ") + half


def own_slides(study: Study) -> list[str]:
    """The sliding motions that are not told as a coordinate of a point already."""
    told = dict(told_as(study))
    return [key for key in _own(study) if key not in told]


def told_as(study: Study) -> Iterator[tuple[str, str]]:
    """Each sliding motion that is a coordinate of a point of chapter 5, with that coordinate."""
    listed = [letter for letter in study.points if not is_trivial(study, letter)]
    places = [f"p_{letter}.{axis}" for letter in listed for axis in "xy"]
    for key in _own(study):
        slid = study.turn.real(key)
        same = (one for one in places if study.varies(one) and np.allclose(study.turn.real(one), slid, equal_nan=True))
        if (place := next(same, None)) is not None:
            yield key, place


def _own(study: Study) -> list[str]:
    """The sliding motions that are not the drive's own."""
    drive = study.turn.real(study.whole.drive.key)
    slides = [column.key for column in study.whole.columns if column.key.startswith("s_")]
    return [key for key in slides if not np.allclose(study.turn.real(key), drive, equal_nan=True)]


def _as_points(study: Study) -> Words:
    """That these slides move as points of chapter 5 do: $s_{56}$ = $x_E$."""
    pairs = [f"${study.whole.info(key).symbol}$ = ${study.whole.info(place).symbol}$" for key, place in told_as(study)]
    if not pairs:
        return Words("", "")
    return Words(
        f"{'、'.join(pairs)}，相应的速度、加速度也相同，不另列。",
        f"{', '.join(pairs)}, with the velocities and accelerations of chapter 5. ",
    )


def _reversed(study: Study) -> Iterator[Words]:
    """That a sliding motion of these tables is one of chapter 4 told from the other link: $s_{23}$ = $−s_{32}$."""
    joints = slides(study.mech)
    for key in own_slides(study):
        joint, shown = joints[key[2:]], study.whole.info(key).symbol
        back = f"{study.mech.number(joint.guide)}{study.mech.number(joint.block)}"
        alike = [stem for stem in "sva" if _is_opposite(study, f"{stem}_{key[2:]}", f"{stem}_{{{back}}}")]
        if shown in study.env or "v" not in alike:
            continue
        first = alike[0]
        told = f"${first}{shown[1:]}$ = $−{first}_{{{back}}}$"
        yield Words(
            f"{told}（第 4 章），{'速度、加速度亦' if first == 's' else '加速度亦'}反号。",
            f"{told} of chapter 4, {'velocity and acceleration' if first == 's' else 'the acceleration'} likewise. ",
        )


def _is_opposite(study: Study, key: str, symbol: str) -> bool:
    own, other = study.turn.real(key), study.env.get(symbol)
    return other is not None and bool(np.allclose(own, -np.asarray(other), rtol=1e-9, atol=1e-9, equal_nan=True))


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


def _of_points(study: Study, letters: list[str], parts: tuple[str, ...]) -> tuple[list[str], Words]:
    keys = [part.format(letter) for letter in letters for part in parts]
    return keys, _motion(study, letters, keys)


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
