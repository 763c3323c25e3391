"""Both centrodes of a link: the poles of many positions on the frame, and carried with the link to its own position."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from ...algebra.formula import row
from ...algebra.quantity import paper
from ...board.board import Board
from ...board.construction import Place, View
from ...board.paper.extent import bounds, box_of
from ...board.paper.marks import Dot, Role
from ...errors import NotAskedError
from ...mechanism.asked.centres import centre
from ...mechanism.asked.curvature import Centrodes, between, centrode_lengths
from ...mechanism.groups.assur import Group
from ...mechanism.model import FRAME
from ...names import Named
from ...plane import Points, dot, nominal
from ...words import Words
from ..centres.copy import mechanism_copied
from ..centres.onto import opened
from ..centres.size import Paper
from ..desk import Desk
from ..positions.placed import placed, refuse_thought
from .pairs import Pair, pairs_of
from .readings import keep_length
from .room import fitted
from .state import Ray
from .strokes.normals import normal_of, refuse_parallel

NAME = "centrodes"
TITLE = Words("瞬心线", "Centrodes")
POLE = "Q"  # letter of the poles one after another: P_12 is the instant centre of links 1 and 2
ARM = 0.5  # of the mechanism's size: of a link with one letter, how far its second point is thought


@dataclass(frozen=True, slots=True, kw_only=True)
class Rolled:
    """One position: two points of the link (mm on the figure), its pole, and the normals that meet there."""

    ends: tuple[Points, Points]
    pole: Points
    rays: tuple[Ray, Ray]


def draw_centrodes(desk: Desk, groups: Sequence[Group], asked: Centrodes, sharing: float, *, alone: bool) -> None:
    """The fixed centrode is the locus of the poles on the frame, the moving one that on the link; they roll. alone:
    whether they are all that is drawn on the diagram."""
    refuse_thought(desk)
    pairs, there = pairs_of(desk.mech, asked.link), [placed(desk, q) for q in asked.drive]
    sheet = _paper(desk, there, asked, pairs, sharing)
    pane = opened(desk.board, NAME, TITLE, sheet, once=alone)
    _say(desk, asked, pane, sheet, pairs)
    if pane is not View.MECHANISM:
        desk.board.depict(pane, *mechanism_copied(desk, sheet, tuple(groups)))
    own = _rolled(desk, desk, asked.link, pairs, sheet.factor, desk.board)
    run = [_rolled(desk, one, asked.link, pairs, sheet.factor, desk.board) for one in there]
    fixed = [one.pole for one in run]
    _draw(desk, pane, fixed, Role.LOCUS, "")
    desk.board.step(_carried_words(desk, asked.link), pane)
    moving = [desk.board.image((*one.ends, one.pole), own.ends) for one in run]
    _draw(desk, pane, moving, Role.CARRIED, "′")
    _name(desk, pane, fixed, moving)
    _polar_rays(desk, pane, own)
    desk.board.plot(pane, own.pole, centre(desk.mech, asked.link, FRAME).symbol)
    _step_off(desk, pane, asked, fixed, moving)


def _polar_rays(desk: Desk, pane: Place, own: Rolled) -> None:
    """The normals that give the pole of this position, as far as the points that tell them."""
    for ray in own.rays:
        spots = [*ray.spots(), own.pole]
        reach = [float(nominal(dot(ray.line.along, spot - ray.line.at))) for spot in spots]
        ends = [spots[reach.index(end)] for end in (min(reach), max(reach))]
        desk.board.join(pane, ends[0], ends[1], Role.CONSTRUCTION)


def _rolled(desk: Desk, there: Desk, link: str, pairs: tuple[Pair, Pair], factor: float, board: Board) -> Rolled:
    """Pole and link in another position."""
    one, two = (normal_of(there, pair, factor, board) for pair in pairs)
    refuse_parallel(one, two, desk.mech.number(link))
    pole = board.meet(one.line, two.line, Words("两法线的交点", "the meeting point of the two normals"))
    pose, arm = there.pose[link], ARM * there.mm(there.mech.scale)
    return Rolled(ends=(pose.origin * factor, (pose.origin + arm * pose.along) * factor), pole=pole, rays=(one, two))


def _paper(desk: Desk, there: Sequence[Desk], asked: Centrodes, pairs: tuple[Pair, Pair], sharing: float) -> Paper:
    """The paper that holds all poles, on the frame and on the link; NotAskedError where they are far away."""
    scratch = desk.board.scratch()
    scratch.step(TITLE)
    own = _rolled(desk, desk, asked.link, pairs, 1.0, scratch)
    run = [_rolled(desk, one, asked.link, pairs, 1.0, scratch) for one in there]
    spots = [one.pole for one in run] + [scratch.image((*one.ends, one.pole), own.ends) for one in run]
    found = fitted(
        desk,
        bounds(desk.board.marks(View.MECHANISM)),
        box_of([complex(nominal(spot)) for spot in spots]),
        sharing,
        NAME,
    )
    if found is None:
        raise NotAskedError(
            Words(
                "有的位置瞬心远在图纸之外，瞬心线无法作图；请缩小 over 的范围",
                "in some of the positions the pole lies far off the sheet: the centrodes cannot be drawn; narrow "
                "`over`",
            ),
            code="off-the-sheet",
        )
    return found


def _normal_told(pair: Pair) -> Words:
    """The line on which the pole lies: the normal of a path of the link."""
    if pair.moving and pair.fixed:
        return Words(f"直线 ${pair.fixed}{pair.moving}$", f"the line ${pair.fixed}{pair.moving}$")
    at = pair.moving or pair.fixed
    return Words(f"过 ${at}$ 的导路垂线", f"the perpendicular to the guide through ${at}$")


def _say(desk: Desk, asked: Centrodes, pane: Place, sheet: Paper, pairs: tuple[Pair, Pair]) -> None:
    n, link, ends = asked.positions, desk.mech.number(asked.link), between(desk.mech, asked)
    pole, (one, two) = centre(desk.mech, asked.link, FRAME).symbol, map(_normal_told, pairs)
    scale = Words.same("") if sheet.shared else Words(f"（{sheet.told}）", f" ({sheet.told})")
    desk.board.step(
        Words(
            f"{one.zh} 与 {two.zh} 的交点即构件 {link} 的绝对瞬心（图示位置为 ${pole}$）。使原动件从 {ends.zh}，等分取 "
            f"{n} 个位置，逐一同样作出，依次记作 ${POLE}_1$ … ${POLE}_{{{n}}}$，连成定瞬心线",
            f"The pole of link {link} is where {one.en} meets {two.en}: ${pole}$ in the given position. Find it "
            f"likewise in {n} equally spaced positions of the input, from {ends.en}, one after the other ${POLE}_1$ to "
            f"${POLE}_{{{n}}}$; their locus is the fixed centrode",
        )
        + scale
        + Words("。", "."),
        pane,
    )


def _carried_words(desk: Desk, link: str) -> Words:
    number = desk.mech.number(link)
    return Words(
        f"将各位置上构件 {number} 与瞬心组成的三角形移到构件现在的位置上，得 ${POLE}^{{′}}_1$ …，连成动瞬心线；"
        f"它随构件 {number} 运动时在定瞬心线上作纯滚动。",
        f"Carry the triangle of link {number} and its pole from every position to the present one: ${POLE}^{{′}}_1$ "
        f"... lie on the moving centrode, which rolls on the fixed one while it moves with link {number}.",
    )


def _draw(desk: Desk, pane: Place, run: Sequence[Points], role: Role, prime: str) -> None:
    board = desk.board
    board.curve(pane, run, role)
    for nth, at in enumerate(run, start=1):
        board.plot(pane, at, f"{POLE}{f'^{{{prime}}}' if prime else ''}_{{{nth}}}", Dot.POINT)


def _name(desk: Desk, pane: Place, fixed: Sequence[Points], moving: Sequence[Points]) -> None:
    """Both curves are named beside the ends at which they part most."""
    apart = [abs(complex(nominal(a - b))) for a, b in zip(fixed, moving, strict=True)]
    end = 1 if apart[0] > apart[-1] else -2
    desk.board.note(pane, fixed[end], Words("定瞬心线", "fixed centrode"))
    desk.board.note(pane, moving[end], Words("动瞬心线", "moving centrode"))


def _step_off(desk: Desk, pane: Place, asked: Centrodes, fixed: Sequence[Points], moving: Sequence[Points]) -> None:
    """Both lengths in chords, by dividers: of curves that roll, arcs between the same poles are equal."""
    desk.board.step(
        Words(
            "用分规逐段量取两条瞬心线上相邻瞬心间的弦长并相加：纯滚动时对应弧长相等，弦长之和也近于相等：",
            "Step off the chords between neighbouring poles of both centrodes: on curves that roll on each other the "
            "arcs between the same poles are equal, so the sums of the chords are nearly equal:",
        ),
        pane,
    )
    for named, run, prime in zip(centrode_lengths(desk.mech, asked.link), (fixed, moving), ("", "^{′}"), strict=True):
        _keep(desk, pane, named, run, prime)


def _keep(desk: Desk, pane: Place, named: Named, run: Sequence[Points], prime: str) -> None:
    board = desk.board
    pairs = enumerate(pairwise(run), start=1)
    chords = [board.measure(a, b, f"{POLE}{prime}_{{{k}}} {POLE}{prime}_{{{k + 1}}}").value for k, (a, b) in pairs]
    total, letters = chords[0], row(f"{POLE}{prime}_{{k}} {POLE}{prime}_{{k+1}}")
    for chord in chords[1:]:
        total = total + chord
    keep_length(board, pane, named, paper(letters, total, summed=True))
