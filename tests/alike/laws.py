"""The laws, each with what it leaves alone."""

from __future__ import annotations

import json
import re
from typing import Any

import numpy as np

from tests.alike.law import Law, mirrored, unnumbered, whole
from tests.alike.said import Line
from tests.generators.library import Data
from tests.generators.retold.moved import Isometry, moved
from tests.generators.retold.renamed import Names
from vecpoly import loads, oracle
from vecpoly.mechanism.model import Mechanism

SAFE = "ABCDEFGHLM"  # letters that stand for nothing else
NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e[-+]?\d+)?")
MM = re.compile(r"(?<![\w.])(-?\d+(?:\.\d+)?(?:e[-+]?\d+)?) mm(?![\w^²³/*])")


def other_letters(rng: np.random.Generator, data: Data) -> Data | None:
    """Each letter another of the same alphabet; the numbers of links stay."""
    names = Names(rng, data)
    texts = [value for load in data.get("loads", {}).values() for value in load.values()]
    if not set(names.letters) <= set(SAFE) or not all(isinstance(text, str) for text in texts):
        return None
    names.number = {link: link for link in names.links}
    names.indexed = False
    names.letter = dict(zip(names.letters, map(str, rng.permutation(list(SAFE))), strict=False))
    new = names.data(data)
    as_they_were = {key: {name: new[key][name] for name in data[key]} for key in ("links", "masses") if key in data}
    return new | {"title": data["title"]} | as_they_were


def in_other_units(rng: np.random.Generator, data: Data) -> Data | None:
    """Powers of ten of millimetres alone: the numbers are the same to the bit."""
    return dict(_tree(data, lambda text: MM.sub(lambda m: f"{m[1]}e-3 m" if "e" not in m[1] else m[0], text)))


def twice_as_large(rng: np.random.Generator, data: Data) -> Data | None:
    """All lengths doubled."""
    if "loads" in data or "masses" in data or re.search(r"m/s|\d (?:cm|m|in)\b", str(data)):
        return None
    return dict(_tree(data, lambda text: MM.sub(lambda m: f"{2 * float(m[1])!r} mm", text)))


def twice_as_fast(rng: np.random.Generator, data: Data) -> Data | None:
    """ω doubled, α four times as large."""
    given = data.get("input")
    if "loads" in data or "masses" in data or not isinstance(given, dict) or "omega" not in given:
        return None
    new = {key: _times(value, {"omega": 2.0, "alpha": 4.0}.get(key)) for key, value in given.items()}
    return data | {"input": new}


def backwards(rng: np.random.Generator, data: Data) -> Data | None:
    """ω reversed, α as it was: at one place of the drive the accelerations are the same."""
    given = data.get("input")
    if "loads" in data or "masses" in data or not isinstance(given, dict) or "omega" not in given or "on" in given:
        return None
    omega = given["omega"]
    sided = re.sub(r"\bc?cw\b", lambda m: "cw" if m[0] == "ccw" else "ccw", omega)
    return data | {"input": given | {"omega": _times(omega, -1.0) if sided == omega else sided}}


def joints_in_another_order(rng: np.random.Generator, data: Data) -> Data | None:
    """Joints, statements and rough places the other way round."""
    new = dict(data)
    for key in ("joints", "branch"):
        new[key] = list(reversed(data.get(key) or []))
    if "guesses" in data:  # loads, masses and friction are told in their order
        new["guesses"] = dict(reversed(list(data["guesses"].items())))
    return {key: value for key, value in new.items() if value or key in data}


def mirror_image(rng: np.random.Generator, data: Data) -> Data | None:
    """y → −y."""
    return _moved(data, Isometry(0.0, True)) if data.get("weight") != "yes" else None


def turned(rng: np.random.Generator, data: Data) -> Data | None:
    """The whole by 37°."""
    return _moved(data, Isometry(37.0, False)) if data.get("weight") != "yes" else None


def _moved(data: Data, by: Isometry) -> Data | None:
    if "friction" in data or "'cam'" in str(data["links"]):
        return None  # sides of friction circles are told by the axes; a cam's own problem has its follower's place
    mech = loads(json.dumps(data)).subject
    if not isinstance(mech, Mechanism) or re.search(r"\b[xy] = ", str(data.get("joints"))):
        return None  # a guide told by a coordinate has a letter of its own then
    if not all(isinstance(text, str) for load in data.get("loads", {}).values() for text in load.values()):
        return None  # a load by a law of the position
    letters = {p for name in mech.bodies for p in mech.link(name).points} - set(data["frame"])
    motion = oracle.solve(mech, order=0)
    return moved(data, by, {p: complex(motion.position(p)) for p in sorted(letters) if p.isalpha()})


def _times(text: str, factor: float | None) -> str:
    return text if factor is None else NUMBER.sub(lambda m: f"{factor * float(m[0])!r}", text, count=1)


def _tree(value: Any, change: Any) -> Any:
    match value:
        case dict():
            return {key: _tree(inner, change) for key, inner in value.items()}
        case list():
            return [_tree(inner, change) for inner in value]
        case str():
            return change(value)
        case _:
            return value


WAYS = re.compile(r"[-−]?\d+(?:\.\d+)?°(?:（[顺逆]时针）| \((?:counter-)?clockwise\))?")  # of a line from the x axis
SENSE = re.compile(r"(?:counter-)?clockwise|[顺逆]时针")
PLACE = re.compile(r"\(.*, .*\) mm$")  # an answer
CHOSEN = re.compile(
    r"（取.*?）|（两条切线.*?）| \((?:of the two|the one|that).*?\)"
)  # by a statement, of which there may be another
LEVEL = re.compile(
    r"the (?:horizontal|vertical|\$x\$ axis)(?: \((?:counter-)?clockwise\))?|（自[^（）]*?[顺逆]时针量）"
    r"|, (?:counter-)?clockwise from the latter|(?:水平|竖直|铅垂|[上下左右]方?)+"
    r"|(?:(?:to the |on the |on its |its )?(?:horizontal(?:ly)?|vertical(?:ly)?|above|below|upwards?|downwards?"
    r"|upper|lower|left|right)(?: of)?\b ?)+"
)


def undirected(line: Line) -> str:
    """Without angles to the axes."""
    if line.text.startswith("p_"):
        return ""  # the way from the origin, which is read by its coordinates
    text = line.text if not line.formula else unnumbered(line)  # digits are told by what a hand may be off by
    return LEVEL.sub("~", WAYS.sub("°", CHOSEN.sub("", PLACE.sub("", text))))


def senseless(line: Line) -> str:
    """Without signs, and without the senses of turning, of which some are reversed and some are not."""
    return SENSE.sub("~", unnumbered(line) if line.formula else line.text).replace("−", "").replace("-", "")


def undirected_mirrored(line: Line) -> str:
    """The same of what was mirrored: its senses are exchanged."""
    return undirected(Line(mirrored(line.text), line.formula))


LAWS = (
    Law(name="letters", retold=other_letters, before=lambda one: one.letterless, after=lambda one: one.letterless),
    Law(name="units", retold=in_other_units, before=whole, after=whole),
    Law(
        name="size",
        retold=twice_as_large,
        before=unnumbered,
        after=unnumbered,
        grown={"mu_l": 2.0, "mu_v": 2.0, "mu_a": 2.0},
    ),
    Law(name="speed", retold=twice_as_fast, before=unnumbered, after=unnumbered, grown={"mu_v": 2.0, "mu_a": 4.0}),
    Law(name="backwards", retold=backwards, before=senseless, after=senseless),
    Law(name="order", retold=joints_in_another_order, before=whole, after=whole, ordered=False),
    Law(name="mirror", retold=mirror_image, before=undirected, after=undirected_mirrored),
    Law(name="turn", retold=turned, before=undirected, after=undirected),
)
