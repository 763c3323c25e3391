"""The theorem of three centres (三心定理): the three centres of any three links lie on one line;
two such lines give the one sought."""

from __future__ import annotations

from ....board.construction import Listing
from ....board.otherwise.amended import plain_letters
from ....board.paper.marks import Dot
from ....board.said.behind import behind
from ....board.said.spaced import spaced
from ....mechanism.asked.centres import Pair, real_links
from ....mechanism.model import Contact
from ....plane import Line, cross, nominal
from ....words import Words
from ...registry import Stage, method
from ..geometry import Centre
from ..state import CentreFigure
from .polygon import join
from .search import GOOD, Search, Way, found

_HEAD = tuple(Words(zh, en) for zh, en in (("瞬心", "Centre"), *(("三角形", "Triangle"), ("连线", "Line")) * 2))
_LEAD = Words(
    "同理求其余瞬心：由三心定理，瞬心所在的两个三角形各给出一条连线，两连线的交点即为该瞬心；三角形多于两个时，取交角最"
    "有利的两条连线；含 $P^{∞}$ 的连线指向该无穷远点。",
    "The remaining centres follow in the same way from the theorem of Kennedy and Aronhold: each is the intersection "
    "of the two lines given by two of its triangles. Where there are more than two triangles, the lines that "
    "cross best are taken; a line with a $P^{∞}$ is drawn towards that point at infinity.",
)
_SMALL = Words(
    "两线交角很小，交点不易准确。", " The lines meet at a small angle; their intersection is poorly defined."
)
_BEST = Words(
    "此两线的交角也小，但在可用的各对直线中已属最好。",
    " These lines also meet at a small angle, but no other pair is better.",
)


@method(
    stage=Stage.CENTRES,
    group="Kennedy",
    source="机械原理, 三心定理 (Kennedy, Aronhold)",
    example="3-2",
    title=Words("三心定理求瞬心", "A centre by the theorem of three centres"),
)
def find_centre(fig: CentreFigure, search: Search) -> None:
    """P_ij lies on P_ik P_kj and on P_il P_lj: where the two lines meet."""
    reasoned, words, other = fig.reasoned, _words(fig, search), _passed_over(fig, search)
    fig.board.step(words, fig.pane)
    fig.board.remark(other)
    if reasoned and _is_met(search):
        fig.board.tabulate(_row(fig, search, behind(spaced(words), spaced(other))))
    ways = tuple(_ruled(fig, search.pair, fig.known.way(search.pair, way.via)) for way in search.ways)
    join(fig.desk, fig.polygon, search.pair, sought=True)
    met = found(Search(pair=search.pair, ways=ways, quality=search.quality, endless=search.endless))
    here = fig.settle(search.pair, met)
    for way in ways:
        if way.line is not None:
            _draw(fig, search.pair, way, way.line, here)
    fig.letter(search.pair, Dot.POINT, _middle(fig, ways))
    _remarks(fig, search, here, best=bool(other.en))


def _ruled(fig: CentreFigure, pair: Pair, way: Way) -> Way:
    """The way with its line laid by rule or set square, named by its two centres."""
    if way.line is None or not way.via:
        return way
    name = "".join(fig.symbol(*side) for side in sides_of(pair, way))
    line = fig.board.parallel(way.line.at, way.line.along, key=plain_letters(name))
    return Way(via=way.via, line=line, at=way.at)


def _draw(fig: CentreFigure, pair: Pair, way: Way, line: Line, here: Centre) -> None:
    """The line through its two centres and the new one; towards a centre off the paper as far as the edge."""
    sides = sides_of(pair, way)
    fig.rule(line, here, *(fig.known.of(*side) for side in sides))
    for target in (*sides, pair):
        if fig.far(*target):
            fig.rule_out(line, target)


def sides_of(pair: Pair, way: Way) -> tuple[Pair, ...]:
    """The two centres through which the line of a way goes."""
    return ((pair[0], way.via), (way.via, pair[1])) if way.via else ()


def _middle(fig: CentreFigure, ways: tuple[Way, ...]) -> complex:
    """Where an arrow towards a centre at infinity starts: at the first line."""
    starts = [complex(nominal(way.line.at)) for way in ways if way.line is not None]
    low, high = fig.paper.corners
    return next((start for start in starts if fig.paper.holds(start)), (low + high) / 2)


def _words(fig: CentreFigure, search: Search) -> Words:
    i, j = search.pair
    p = f"${fig.symbol(i, j)}$"
    if search.ways[0].at is not None:
        via = search.ways[0].via
        a, b = (f"${fig.letters(*side)}$" for side in ((i, via), (via, j)))
        return Words(
            f"求 {p}：{a} 与 {b} 重合，三个构件在该处速度相同，{p} 也在该处。",
            f"Find {p}: the centres {a} and {b} coincide, and there the three links have one velocity, so {p} is "
            "there too.",
        )
    triangles = [f"△{_corners(fig, search.pair, way)}" for way in search.ways if way.via]
    lines = [_line(fig, search.pair, way) for way in search.ways]
    if fig.reasoned and _is_met(search):
        return Words(
            f"由{'、'.join(triangles)} 得 {p}，它是{lines[0].zh}与{lines[1].zh}的交点。",
            f"From {' and '.join(triangles)}, {p} is the intersection of {lines[0].en} and {lines[1].en}.",
        )
    fig.reasoned |= len(triangles) > 1
    shared = Words(
        f"边 {fig.numbers(i, j)} 为{'、'.join(triangles)} 的公共边，故 " if len(triangles) > 1 else "",
        f"the side {fig.numbers(i, j)} closes the triangles {' and '.join(triangles)}, so "
        if len(triangles) > 1
        else "",
    )
    return Words(
        f"求 {p}：{shared.zh}{p} 既在{lines[0].zh}上，又在{lines[1].zh}上",
        f"Find {p}: {shared.en or 'the centre '}{p} lies on {lines[0].en} and on {lines[1].en}",
    ) + _where(fig, search)


def _is_met(search: Search) -> bool:
    """Whether the centre is where two lines meet, each of them closed by a side of two triangles."""
    return search.ways[0].at is None and len([way for way in search.ways if way.via]) > 1 and not search.endless


def _row(fig: CentreFigure, search: Search, words: Words) -> Listing:
    """Centre, and twice a triangle and the line that it gives."""
    cells = [cell for way in search.ways for cell in (_corners(fig, search.pair, way), _name(fig, search.pair, way))]
    return Listing(head=_HEAD, rows=((f"${fig.symbol(*search.pair)}$", *cells),), told=words, lead=_LEAD)


def _corners(fig: CentreFigure, pair: Pair, way: Way) -> str:
    """136: of a triangle, by the numbers of the links."""
    return fig.numbers(*sorted((pair[0], way.via, pair[1]), key=real_links(fig.mech).index))


def _name(fig: CentreFigure, pair: Pair, way: Way) -> str:
    """The line through two centres, by both."""
    return f"${''.join(fig.letters(*side) for side in sides_of(pair, way))}$"


def _line(fig: CentreFigure, pair: Pair, way: Way) -> Words:
    """What line it is: through two centres, parallel to a direction, a normal, or the line at infinity."""
    if not way.via:
        contact = next((c for c in fig.mech.contacts if set(c.links) == set(pair)), None)
        at = contact.point if isinstance(contact, Contact) else ""
        return Words(
            f"接触点{f' ${at}$ ' if at else ''}的公法线 $nn$ ",
            f"the common normal $nn$ at the contact{f' ${at}$' if at else ''}",
        )
    sides = sides_of(pair, way)
    ends = [fig.known.of(*side) for side in sides]
    names = [fig.letters(*side) for side in sides]
    if all(end.endless for end in ends):
        return Words(
            f" ${names[0]}$、${names[1]}$ 所定的无穷远直线", f"the line at infinity of ${names[0]}$ and ${names[1]}$"
        )
    if any(end.endless for end in ends):
        near, away = names if ends[1].endless else names[::-1]
        return Words(f"过 ${near}$ 且指向 ${away}$ 的直线", f"the line through ${near}$ towards ${away}$")
    return Words(f"直线 ${names[0]}{names[1]}$ ", f"the line ${names[0]}{names[1]}$")


def _where(fig: CentreFigure, search: Search) -> Words:
    p = f"${fig.symbol(*search.pair)}$"
    if search.endless:
        if any(way.line is None for way in search.ways):
            return Words(
                f"，因此 {p} 在无穷远处，方向沿后一直线。"
                if search.ways[0].line is None
                else f"，因此 {p} 在无穷远处，方向沿前一直线。",
                f": {p} is at infinity, in the direction of that other line.",
            )
        return Words(f"；两线平行，{p} 在无穷远处。", f"; they are parallel, and {p} is at infinity.")
    return Words(f"，两线的交点即为 {p}。", "; it is their intersection.")


def _remarks(fig: CentreFigure, search: Search, here: Centre, *, best: bool) -> None:
    """A centre off the paper; an uncertain meeting, which may be the best there is (others were passed over)."""
    lines = [way.line for way in search.ways if way.line is not None]
    far = [f"${fig.symbol(*side)}$" for way in search.ways for side in sides_of(search.pair, way) if fig.far(*side)]
    if far:
        off = tuple(dict.fromkeys(far))
        fig.board.remark(
            Words(
                f"（{'、'.join(off)} 在图外，通向它的连线用比例线段法作出。）",
                f" (Off the paper: {', '.join(off)}; lines towards there are drawn by proportional segments.)",
            )
        )
    if search.pair in fig.paper.far:
        p = f"${fig.symbol(*search.pair)}$"
        fig.board.remark(Words(f"（{p} 落在图外。）", f" (Point {p} falls off the paper.)"))
    elif len(lines) == 2 and not here.endless and abs(float(nominal(cross(lines[0].along, lines[1].along)))) < GOOD:
        fig.board.remark(_BEST if best else _SMALL)


def _passed_over(fig: CentreFigure, search: Search) -> Words:
    """Why not the first triangles: their lines are nearly parallel, or lead off the paper."""
    ways = tuple(fig.known.ways(search.pair))
    if (
        len(ways) < 3
        or search.ways[0].at is not None
        or [way.via for way in ways[:2]] == [way.via for way in search.ways]
    ):
        return Words.same("")
    one, two = (_line(fig, search.pair, way) for way in ways[:2])
    return Words(
        f"{one.zh}与{two.zh}的交点更不易准确，故不用。".lstrip(),
        f" The intersection of {one.en} and {two.en} would be less well defined.",
    )
