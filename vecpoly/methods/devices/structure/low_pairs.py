"""高副低代 as it is drawn and told: every higher pair replaced by a link with two lower pairs."""

from __future__ import annotations

from ....algebra.quantity import Times
from ....board.construction import View
from ....devices.structure import Structure
from ....devices.structure_named import F_LOW, N_LOW, P_LOW
from ....devices.structure_pairs import Form, Pair
from ....names import subscripted
from ....words import Words
from ..bench import Bench
from .count import freedom
from .replacement import Replaced
from .sketch import draw_chain, draw_replaced, pane


def draw_replacement(bench: Bench, device: Structure, low: Replaced) -> None:
    """高副低代: every higher pair by a link with two lower pairs."""
    board = bench.board
    board.section(Words("高副低代", "Higher pairs replaced by lower pairs"))
    place = pane(board, View.MECHANISM, "low", Words("高副低代后的机构", "Equivalent lower-pair linkage"))
    for sub in low.substitutes:
        board.step(_replaced_by(device, sub.of, sub.link, sub.pairs), place)
        draw_replaced(board, place, device, sub.of)
    draw_chain(board, place, device, low.chain, device.drive_sets[0] if device.drivers else ())
    board.step(
        Words(
            "高副低代后，构件数、低副数和自由度为（自由度应不变）：",
            "After the replacement the numbers of links and of lower pairs, and the degree of freedom, which must not "
            "change, are:",
        )
    )
    n, p = bench.stated(N_LOW, float(len(low.chain.links))), bench.stated(P_LOW, float(low.chain.lower))
    bench.worked(F_LOW, Times(3, n) - Times(2, p))
    assert freedom(low.chain) == 3 * len(low.chain.links) - 2 * low.chain.lower


def _replaced_by(device: Structure, pair: Pair, link: str, pairs: tuple[Pair, Pair]) -> Words:
    """By which link, pinned or sliding where."""
    one, two = pairs
    if pair.form is Form.G:
        return Words(
            f"齿轮高副 ${subscripted(pair.letter)}$：过节点 ${subscripted(pair.letter)}$ 作压力角 20° 的啮合线，"
            f"自两轮中心向它引垂线，以垂足 ${subscripted(one.letter)}$、${subscripted(two.letter)}$ 为铰链、"
            f"构件 {link} 为连杆代替。",
            f"Gear pair ${subscripted(pair.letter)}$: through the pitch point draw the line of "
            f"action at 20°; a link {link}, pinned at the feet ${subscripted(one.letter)}$ and "
            f"${subscripted(two.letter)}$ of the perpendiculars from the two centres, replaces it.",
        )
    flat = next((end for end in pairs if end.form is Form.P), None)
    if flat is not None:
        pin = one if flat is two else two
        return Words(
            f"高副 ${subscripted(pair.letter)}$ 有一平直轮廓：用构件 {link} 代替，"
            f"它在曲率中心 ${subscripted(pin.letter)}$ 铰接，并沿平直轮廓移动。",
            f"The higher pair ${subscripted(pair.letter)}$ has a flat face: link {link} replaces it, "
            f"pinned at the centre of curvature ${subscripted(pin.letter)}$ and sliding along the "
            "face.",
        )
    a, b = (device.number(end.links[0]) for end in pairs)
    return Words(
        f"高副 ${subscripted(pair.letter)}$：用构件 {link} 代替，它在两轮廓的曲率中心 "
        f"${subscripted(one.letter)}$、${subscripted(two.letter)}$ 处分别与构件 {a}、{b} 铰接。",
        f"Link {link} replaces the higher pair ${subscripted(pair.letter)}$; it is pinned to links {a} and "
        f"{b} at the centres of curvature ${subscripted(one.letter)}$ and "
        f"${subscripted(two.letter)}$.",
    )
