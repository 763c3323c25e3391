"""Full-width signs outside quoted and spoken texts, made narrow line by line: ｛AB：100 mm｝ → {AB: 100 mm}.

So are parentheses round two components: A: (0 mm, 0 mm) → A: [0 mm, 0 mm].
Where a sign could mean two things it is a fault with its line and column. Signs change one for one, but for a space
that YAML wants behind a colon; `Narrowed.column` counts it out again.
"""

from __future__ import annotations

from dataclasses import dataclass, field

from ...errors import Fault, Place, ProblemFileError
from ...foundation.patterns import pattern
from ...words import Words
from .flow import Flow
from .signs import FILES, OPENING, PAIRS, QUOTES, ROUND, TEXTS, WIDE, narrow, remedy, squared

_KEY = pattern(r"([\w.'′＿．－/／-]+)[ \u3000]*(:(?=[ \u3000]|$)|：)[ \u3000]*")
_DASH = pattern(r"-(?= |$) *")


@dataclass(slots=True)
class Narrowed:
    """A text with narrow signs, and where spaces were put in (line → columns of the new text), both from 0."""

    text: str
    spaces: dict[int, list[int]] = field(default_factory=dict)

    def column(self, line: int, column: int) -> int:
        """The column of the text as written."""
        return column - sum(place < column for place in self.spaces.get(line, ()))


def narrowed(text: str, name: str) -> Narrowed:
    """The text with narrow signs; raises ProblemFileError for signs in doubt, each with its line and column."""
    if not WIDE.search(text) and not ROUND.search(text):
        return Narrowed(text)
    reader = _Lines(name)
    lines = [reader.line(number, line) for number, line in enumerate(text.split("\n"))]
    if reader.faults:
        raise ProblemFileError.of(*reader.faults)
    return Narrowed("\n".join(lines), reader.spaces)


class _Lines:
    """Walks the lines and keeps what is open:
    keys by their indents, a flow collection, a quoted text, a spoken text."""

    def __init__(self, name: str) -> None:
        self.name, self.faults, self.spaces = name, list[Fault](), dict[int, list[int]]()
        self.keys: list[tuple[int, str]] = []
        self.flow: Flow | None = None
        self.quote, self.spoken = "", -1

    def line(self, number: int, line: str) -> str:
        """One line, narrow."""
        if self.flow and self._left_open(line):
            self.flow = None
        out = self._open(line) if self.flow or self.quote else self._block(number, line)
        self._doubt(number, out)
        put = [at for sign, at in out if at < 0]
        if put:
            self.spaces[number] = [i for i, (_, at) in enumerate(out) if at < 0]
        return "".join(sign for sign, _ in out).replace("\ue000", "")

    def _left_open(self, line: str) -> bool:
        """Whether a key stands here, no further in than the one whose brackets are still open: they were forgotten."""
        indent = len(line) - len(line.lstrip(" "))
        return bool(self.keys) and indent <= self.keys[-1][0] and _KEY.match(line, indent) is not None

    def _open(self, line: str) -> Signs:
        """A line inside something that an earlier line opened."""
        if self.flow:
            out = self.flow.line(line, 0)
            self.flow = None if self.flow.closed else self.flow
            return out
        end = _end_of_quote(line, 0, self.quote)
        self.quote = "" if end else self.quote
        return _same(line, 0)

    def _block(self, number: int, line: str) -> Signs:
        indent = len(line) - len(line.lstrip(" "))
        if not line.strip() or line.lstrip().startswith("#") or (0 <= self.spoken < indent):
            return _same(line, 0)
        self.spoken = -1
        if line[indent] == "\u3000":
            self._fault(number, indent, "\u3000", " ")
            return _same(line, 0)
        self.keys = [(at, key) for at, key in self.keys if at < indent]
        return _same(line[:indent], 0) + self._item(line, indent, indent)

    def _item(self, line: str, start: int, indent: int) -> Signs:
        """`- `, a key with its colon, and a value."""
        if dash := _DASH.match(line, start):
            return _same(dash[0], start) + self._item(line, dash.end(), dash.end())
        found = _KEY.match(line, start)
        if found is None or not (found[1].isascii() or WIDE.search(found[1]) or "title_block" in self._names()):
            return self._value(line, start, indent)
        key = "".join(map(narrow, found[1]))
        self.keys.append((indent, key))
        out = [(sign, found.start(1) + i) for i, sign in enumerate(key)]
        out.append((":", found.start(2)))
        gap = found.end() - found.end(2)
        out += [(" ", found.end(2) + i) for i in range(gap)] or [(" ", -1)] * (found.end() < len(line))
        return out + self._value(line, found.end(), indent)

    def _value(self, line: str, start: int, indent: int) -> Signs:
        names, rest = self._names(), line[start:]
        texts, files = bool(names & TEXTS), bool(names & FILES)
        first = rest[:1]
        if first in OPENING and (first in "{[｛" or not texts):
            flow = Flow(frozenset(names))
            out = flow.line(line, start)
            self.flow = None if flow.closed else flow
            return out
        if first in ("(", "（") and names & PAIRS and not texts and (pair := ROUND.match(line, start)):
            return [(sign, start + i) for i, sign in enumerate(squared(pair[0]))] + _same(
                line[pair.end() :], pair.end()
            )
        if first and first in "\"'":
            self.quote = "" if _end_of_quote(line, start + 1, first) else first
            return _same(line[start:], start)
        if (texts and rest.strip()) or first in ("|", ">"):
            self.spoken = indent
            return _same(rest, start)
        return _plain(line, start, files)

    def _names(self) -> set[str]:
        return {key for _, key in self.keys}

    def _doubt(self, number: int, out: Signs) -> None:
        for i, (sign, at) in enumerate(out):
            if i and out[i - 1][0] == "\ue000":
                self._fault(number, at, sign, remedy(sign) or "")

    def _fault(self, number: int, column: int, sign: str, better: str) -> None:
        what = (
            Words("全角空格", "a full-width space")
            if sign == "\u3000"
            else Words(f"全角字符“{sign}”", f"the full-width '{sign}'")
        )
        instead = Words("半角空格", "plain spaces") if better == " " else Words(f"半角“{better}”", f"'{better}'")
        said = Words(f"{what.zh}在此含义不明", f"{what.en} has no clear meaning here") + (
            Words(
                f"；请写{instead.zh}，或将整个文本放在引号内",
                f"; write {instead.en}, or put the whole text between quotes",
            )
            if better
            else Words("；请删去，或将整个文本放在引号内", "; leave it out, or put the whole text between quotes")
        )
        self.faults.append(
            Fault(said=said, code="full-width", place=Place(self.name, number + 1, column + 1), numbers={"sign": sign})
        )


Signs = list[tuple[str, int]]  # each sign with its column as written; −1: put in; a sign in doubt follows \ue000


def _same(text: str, start: int) -> Signs:
    return [(sign, start + i) for i, sign in enumerate(text)]


def _plain(line: str, start: int, files: bool) -> Signs:
    """A value without brackets: 10 rad/s 逆时针."""
    rest = line[start:]
    bare = rest.split(" #")[0].rstrip()
    if len(bare) > 1 and bare[0] in QUOTES and bare[-1] == QUOTES[bare[0]]:
        return [
            ('"', start),
            *_same(bare[1:-1], start + 1),
            ('"', start + len(bare) - 1),
            *_same(rest[len(bare) :], start + len(bare)),
        ]
    if files:
        return _same(rest, start)
    out: Signs = []
    for i, sign in enumerate(bare):
        if remedy(sign) is not None and sign != "‘":
            out.append(("\ue000", start + i))
            out.append((sign, start + i))
        else:
            out.append((narrow(sign), start + i))
    return out + _same(rest[len(bare) :], start + len(bare))


def _end_of_quote(line: str, start: int, quote: str) -> bool:
    """Whether the quoted text ends on this line."""
    rest = line[start:].replace("\\\\", "").replace('\\"', "") if quote == '"' else line[start:].replace("''", "")
    return quote in rest
