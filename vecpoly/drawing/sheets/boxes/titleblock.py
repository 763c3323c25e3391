"""The furniture of a sheet: frame, title strip with blanks for the name,
and the bar that proves the print true to scale."""

from __future__ import annotations

from ....foundation.slotted import dataclass
from ....typeset import Box, layout_words
from ....typeset.box import place, scaled
from ....words import Lang, Words, label
from ...labels.notes import WIDE_SPACE, folded
from ...scene import Item, Layer, Rect, Stroke, TextBox
from ...style import GIVEN, NOTE, RESULT, THIN
from ..space import FRAME, STRIP

BAR = 50.0
BAR_CELL = 62.0  # width of the strip's last cell
LOWER = 0.45  # of the strip: the height of its lower row
UNDER = 0.38  # the same under a title of two lines, which needs more
EVEN = 0.5  # the same where both rows have two lines
ONE_LINE = 1.5 * NOTE  # higher type stands on two lines
CLOSE = 1.15  # baseline to baseline in the strip, em
UNNAMED = Words.same("")
LABELS = {
    "sheet": Words("第 {n} 张　共 {total} 张", "Sheet {n} of {total}"),
    "name": Words("姓名", "Name"),
    "number": Words("学号", "No."),
    "group": Words("班级", "Class"),
    "date": Words("日期", "Date"),
    "bar": Words("打印后此线应为 50 mm", "50 mm when printed true to scale"),
}
TO_BE_DRAWN = "to be drawn"  # the hand of a blank sheet
HANDS = {
    "exact": Words("作图：精确", "Drawn exactly"),
    "drafting": Words("作图：仪器绘图", "Drawn with instruments"),
    "pencil": Words("作图：铅笔", "Drawn in pencil"),
    TO_BE_DRAWN: Words("请用仪器作图", "To be drawn with instruments"),
}
FINELY = {  # how the hand reads; the exact one is not said to
    "drafting": Words("，读至 0.1 mm", ", read to 0.1 mm"),
    "pencil": Words("，读至 0.5 mm", ", read to 0.5 mm"),
    TO_BE_DRAWN: Words("，量至 0.1 mm", ", read to 0.1 mm"),
}


@dataclass(frozen=True, slots=True, kw_only=True)
class Strip:
    """What the title strip says; read: whether anything is measured on the drawing."""

    problem: str
    title: Words
    hand: str
    number: int
    total: int
    read: bool = True
    name: Words = UNNAMED  # of the sheet as a figure of a report


def furniture(page: Rect, strip: Strip, lang: Lang, *, blanks: bool = True) -> tuple[Item, ...]:
    """Frame, strip and check bar of one sheet; blanks: for the name, which a plate in a report has not;
    nor has one that stands alone a number."""
    frame = page.grown(-FRAME)
    y, x1 = frame.y0 + STRIP, frame.x1
    x_bar = x1 - BAR_CELL
    x_name = frame.x0 + 0.44 * (x1 - frame.x0) if blanks else x_bar
    numbered = blanks or strip.total > 1
    title, hand, sheet = _told(strip, lang, x_name - frame.x0 - 4, numbered=numbered)
    lower = _lower(title, hand)
    mid = frame.y0 + lower * STRIP
    x_half = (x_name + x_bar) / 2
    ruled = [
        _line(complex(frame.x0, y), complex(x1, y), GIVEN),
        *(_line(complex(x, frame.y0), complex(x, y), GIVEN) for x in dict.fromkeys((x_name, x_bar))),
        *([_line(complex(x_half, frame.y0), complex(x_half, y), THIN)] if blanks else []),
        _line(complex(frame.x0, mid), complex(x_bar, mid), THIN),
    ]
    border = Stroke(points=frame.corners, width=RESULT, closed=True)
    return (
        border,
        *ruled,
        _text(title, frame.x0 + 2, frame.y0 + (1 + lower) / 2 * STRIP),
        _text(hand, frame.x0 + 2, frame.y0 + lower / 2 * STRIP),
        _text(sheet, x_name - 2 - sheet.width, frame.y0 + lower / 2 * STRIP),
        *(_blanks(frame, x_name, x_half, lang, lower) if blanks else ()),
        *check_bar(complex((x_bar + x1 - BAR) / 2, frame.y0 + 4.2), lang),
    )


def _told(strip: Strip, lang: Lang, room: float, *, numbered: bool) -> tuple[Box, Box, Box]:
    """What the sheet is, by which hand, and which of how many it is; room: the width of their cells, mm."""
    title, name = strip.title.of(lang), label(strip.problem).of(lang)
    full = WIDE_SPACE.join(filter(None, (strip.name.of(lang), name or ("" if title else strip.problem), title)))
    drawn = HANDS.get(strip.hand, Words(f"作图：{strip.hand}", f"Drawn {strip.hand}"))
    hand = (drawn + FINELY.get(strip.hand, Words.same("")) if strip.read else drawn).of(lang)
    sheet = layout_words(LABELS["sheet"].of(lang).format(n=strip.number, total=strip.total) if numbered else "", NOTE)
    return _fitted(full, NOTE * 1.2, room), _fitted(hand, NOTE, room - sheet.width - 3), sheet


def _lower(title: Box, hand: Box) -> float:
    """The share of the strip that its lower row takes: two lines of type keep a margin."""
    if title.height <= ONE_LINE:
        return LOWER if hand.height <= ONE_LINE else 1 - UNDER
    return UNDER if hand.height <= ONE_LINE else EVEN


def _blanks(frame: Rect, x0: float, x1: float, lang: Lang, low: float) -> tuple[Item, ...]:
    upper, lower = (1 + low) / 2, low / 2
    cells = (("group", x0, upper), ("name", x1, upper), ("number", x0, lower), ("date", x1, lower))
    return tuple(
        _text(layout_words(LABELS[key].of(lang), NOTE), x + 1.2, frame.y0 + part * STRIP) for key, x, part in cells
    )


def check_bar(at: complex, lang: Lang) -> tuple[Item, ...]:
    """A bar of 50 mm from `at` to the right, a tick every 10 mm, and what it is for."""
    ticks = (_line(at + x, at + x + 1j * (2.6 if x in (0, BAR) else 1.6), THIN) for x in (0, 10, 20, 30, 40, BAR))
    note = _fitted(LABELS["bar"].of(lang), NOTE, BAR_CELL - 4)
    return (_line(at, at + BAR, GIVEN), *ticks, _text(note, at.real + (BAR - note.width) / 2, at.imag + 6.6))


def _line(a: complex, b: complex, width: float) -> Stroke:
    return Stroke(points=(a, b), width=width)


def _text(box: Box, x: float, middle: float) -> TextBox:
    return TextBox(box=box, x=x, y=middle - (box.ascent - box.descent) / 2, layer=Layer.TEXT)


def _fitted(text: str, em: float, room: float) -> Box:
    """A line of type; in the size of notes where it would not fit its cell, or else two lines of it: no size between,
    and a smaller one only where a line were longer than the cell."""
    box = layout_words(text, em)
    if box.width <= room:
        return box
    both = [layout_words(line, NOTE) for line in folded(text, NOTE, room).split("\n")]
    made = place([(0.0, -CLOSE * NOTE * i, one) for i, one in enumerate(both)], max(one.width for one in both))
    return made if made.width <= room else scaled(made, room / made.width)
