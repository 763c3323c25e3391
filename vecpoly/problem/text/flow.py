"""A collection in brackets, sign by sign:
which full-width signs are its punctuation, and which belong to a text in it."""

from __future__ import annotations

from dataclasses import dataclass

from ...foundation.patterns import pattern
from .signs import CLOSING, FILES, OPENING, PAIRS, QUOTES, ROUND, TEXTS, narrow, remedy, squared

Signs = list[tuple[str, int]]
_NEXT_KEY = pattern(r"[ \u3000]*(zh|en|note)[ \u3000]*[:：]")
_NEXT_FIELD = pattern(r"[ \u3000]*\w{1,8}[ \u3000]*[:：]")
_WORD = pattern(r"[\w.'′＿．－/／-]+")


@dataclass(slots=True)
class Frame:
    """One pair of brackets: what closes it, the key before the value being read,
    the value's text so far, and what stood in quotes there."""

    closer: str
    key: str = ""
    so_far: str = ""
    quoted: str = ""


class Flow:
    """Reads a flow collection, over several lines where it must."""

    def __init__(self, above: frozenset[str]) -> None:
        self.above, self.frames, self.quote, self.closed = above, list[Frame](), "", False

    def line(self, line: str, start: int) -> Signs:
        """The signs of a line from a column on."""
        out: Signs = []
        at = start
        while at < len(line):
            at = self._sign(line, at, out)
        if self.frames and not self.quote:
            self.frames[-1].so_far += " "
        return out

    def _sign(self, line: str, at: int, out: Signs) -> int:
        """One sign, or a quoted text; the column behind it."""
        sign = line[at]
        if self.quote:
            return self._quoted(line, at, out)
        if self.closed or (sign == "#" and at and line[at - 1] == " "):
            out += [(one, at + i) for i, one in enumerate(line[at:])]
            return len(line)
        fresh = not self.frames or not self.frames[-1].so_far.strip()
        if fresh and (sign in "\"'" or (sign in QUOTES and QUOTES[sign] in line[at + 1 :] and not self._spoken())):
            return self._open_quote(line, at, out)
        if sign in OPENING and (fresh if sign not in "{[" else True) and not (sign == "【" and self._spoken()):
            return self._push(at, out, OPENING[sign])
        if sign in CLOSING and self.frames and self._closes(line, at, sign):
            return self._pop(at, out, CLOSING[sign])
        if fresh and sign in "(（" and self._names() & PAIRS and not self._spoken() and (pair := ROUND.match(line, at)):
            out += [(one, at + i) for i, one in enumerate(squared(pair[0]))]
            self.frames[-1].so_far = "…"
            return pair.end()
        return self._inside(line, at, out)

    def _inside(self, line: str, at: int, out: Signs) -> int:
        sign, frame = line[at], self.frames[-1]
        key = frame.quoted or frame.so_far.strip()  # JSON has its keys in quotes
        if sign in ":：" and not frame.key and (frame.closer == "}" or not self._spoken()) and _WORD.fullmatch(key):
            frame.key, frame.so_far, frame.quoted = "".join(map(narrow, key)), "", ""
            out.append((":", at))
            if sign == "：" and line[at + 1 : at + 2] not in (" ", "\u3000"):
                out.append((" ", -1))
            return at + 1
        if sign == "," or (sign in "，、" and self._separates(line, at, sign)):
            frame.key, frame.so_far, frame.quoted = "", "", ""
            out.append((",", at))
            return at + 1
        frame.so_far += sign
        self._letter(sign, at, out)
        return at + 1

    def _letter(self, sign: str, at: int, out: Signs) -> None:
        if self._spoken() or self._file():
            out.append((" " if sign == "\u3000" and not self.frames[-1].so_far.strip() else sign, at))
        elif remedy(sign) is not None:
            out += [("\ue000", at), (sign, at)]
        else:
            out.append((narrow(sign), at))

    def _separates(self, line: str, at: int, sign: str) -> bool:
        if self.frames[-1].so_far.strip() == "…":
            return True
        if "title_block" in self.above:
            return sign == "，" and bool(_NEXT_FIELD.match(line, at + 1))
        if self._spoken():
            return sign == "，" and bool(_NEXT_KEY.match(line, at + 1))
        return True

    def _closes(self, line: str, at: int, sign: str) -> bool:
        if sign in "}]":
            return True
        follows = line[at + 1 :].lstrip(" \u3000")[:1]
        return not self._spoken() or (
            CLOSING[sign] == self.frames[-1].closer == "}" and (not follows or follows in ",，}]｝］#")
        )

    def _names(self) -> set[str]:
        return set(self.above) | {frame.key for frame in self.frames}

    def _spoken(self) -> bool:
        """Whether the value being read is a text for people."""
        if self.frames and self.frames[-1].closer == "}" and not self.frames[-1].key:
            return False
        return bool(self._names() & TEXTS)

    def _file(self) -> bool:
        return bool(self._names() & FILES) and not (self.frames[-1].closer == "}" and not self.frames[-1].key)

    def _push(self, at: int, out: Signs, closer: str) -> int:
        self.frames.append(Frame(closer))
        out.append(("{" if closer == "}" else "[", at))
        return at + 1

    def _pop(self, at: int, out: Signs, closer: str) -> int:
        self.frames.pop()
        out.append((closer, at))
        self.closed = not self.frames
        if self.frames:
            self.frames[-1].so_far, self.frames[-1].quoted = "…", ""  # a collection stood there
        return at + 1

    def _open_quote(self, line: str, at: int, out: Signs) -> int:
        out.append(('"' if line[at] in QUOTES else line[at], at))
        self.quote = QUOTES.get(line[at], line[at])
        self.frames[-1].so_far, self.frames[-1].quoted = "…", ""
        return at + 1

    def _quoted(self, line: str, at: int, out: Signs) -> int:
        sign = line[at]
        if sign == "\\" and self.quote == '"' and at + 1 < len(line):
            self.frames[-1].quoted += line[at : at + 2]
            out += [(sign, at), (line[at + 1], at + 1)]
            return at + 2
        if sign == self.quote:
            self.quote = ""
            out.append(('"' if sign in QUOTES else sign, at))
        else:
            self.frames[-1].quoted += sign
            out.append((sign, at))
        return at + 1
