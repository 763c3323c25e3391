"""That curvatures of paths are asked: of which link, by which construction, with which centrodes."""

from __future__ import annotations

from collections.abc import Mapping

from ...errors import FaultError
from ...limits import CENTRODES
from ...mechanism.asked.curvature import Centrodes, Curvature, Way, centrode_lengths, of_link
from ...mechanism.model import FRAME, Mechanism
from ...names import Named
from ...units.reading import Dim, pure, read
from ...words import Words
from ..schema.faults import Faults, meant
from ..schema.models import FindSpec, ProblemSpec
from .asks import AskNamed
from .wanted import CURVED, refuse_beside

NAME = "curvature"
OWN = ("positions", "over")  # of an entry that asks centrodes
POSITIONS, SPREAD = 10, 45.0  # of centrodes of which nothing is said: so many, so many degrees to both sides


def is_curved(spec: ProblemSpec) -> bool:
    """Whether curvatures are asked."""
    return spec.method == NAME


def curved_quantities(spec: ProblemSpec, mech: Mechanism, faults: Faults) -> dict[str, Named]:
    """What may be asked of the curvatures of paths: of every link that moves; nothing by another method."""
    if is_curved(spec):
        return {key: named for link in mech.numbered for key, named in of_link(mech, link).items()}
    if spec.construction is not None:
        with faults.at("construction"):
            raise FaultError(
                Words("construction 只用于 method: curvature", "'construction' goes with method: curvature only")
            )
    for i, item in enumerate(spec.find):
        if (isinstance(item, str) and CURVED.match(item)) or (isinstance(item, FindSpec) and item.centrodes):
            with faults.at("find", i):
                what = item if isinstance(item, str) else "centrodes"
                if what not in {f"p_{letter}" for link in mech.links for letter in link.points}:
                    raise FaultError(
                        Words(
                            f"求“{what}”须写 method: curvature",
                            f"'{what}' is found by curvatures: write method: curvature",
                        ),
                        code="missing",
                    )
    return {}


def read_centrodes(item: FindSpec, mech: Mechanism) -> Centrodes:
    """{centrodes: 2, positions: 10, over: [20 deg, 110 deg]}; raises FaultError."""
    refuse_beside(item, "centrodes", OWN)
    link = item.centrodes or ""
    if link not in mech.numbered:
        raise FaultError(
            Words(f"构件“{link}”不存在", f"link '{link}' does not exist") + meant(link, mech.numbered),
            "centrodes",
            code="unknown-name",
        )
    count = POSITIONS if item.positions is None else pure(item.positions, "10")
    low, high = CENTRODES
    if count != int(count) or not low <= count <= high:
        raise FaultError(
            Words(
                f"positions 为 {count:g}；瞬心线应取 {low} 至 {high} 个位置",
                f"positions is {count:g}; centrodes are drawn through {low} to {high} positions",
            ),
            "positions",
            code="range",
        )
    start, end = _over(item, mech)
    return Centrodes(link=link, start=start, end=end, positions=int(count))


def _over(item: FindSpec, mech: Mechanism) -> tuple[float, float]:
    """First and last position of the drive."""
    if item.over is None:
        if mech.drive.slide:
            raise FaultError(
                Words(
                    "请写出输入的首末位置，如 over: [20 mm, 60 mm]", "say over which positions: over: [20 mm, 60 mm]"
                ),
                "over",
                code="missing",
            )
        half = read(f"{SPREAD} deg", Dim.ANGLE).si
        return mech.drive.position - half, mech.drive.position + half
    dim = Dim.LENGTH if mech.drive.slide else Dim.ANGLE
    start, end = (read(text, dim).si for text in item.over)
    if start == end:
        raise FaultError(Words("over 的首末位置相同", "both positions of 'over' are the same"), "over")
    return start, end


def curvature_of(
    spec: ProblemSpec, mech: Mechanism, asks: tuple[object, ...], centrodes: Centrodes | None, faults: Faults
) -> Curvature | None:
    """Of the one link of which something is asked; faults where it is none, or where there are two."""
    if not is_curved(spec):
        return None
    keys = [ask.rel.key for ask in asks if isinstance(ask, AskNamed)]
    links = _links(mech, keys, centrodes)
    if len(links) != 1:
        with faults.at("find"):
            raise FaultError(_one_link(links, mech), code="contradiction" if links else "missing")
        return None
    way = Way(spec.construction or Way.BOBILLIER)
    return Curvature(link=links[0], way=way, centrodes=centrodes)


def _links(mech: Mechanism, keys: list[str], centrodes: Centrodes | None) -> list[str]:
    """The links that carry all that is asked, as few as there can be."""
    asked = set(keys) - {named.key for link in mech.numbered for named in centrode_lengths(mech, link)}
    own = {link: asked & of_link(mech, link).keys() for link in mech.numbered}
    whole = [link for link in mech.numbered if asked and own[link] == asked]
    if centrodes is not None:
        others = [] if not asked or centrodes.link in whole else [link for link in mech.numbered if own[link]]
        return [centrodes.link, *(link for link in others if link != centrodes.link)]
    return whole[:1] or [link for link in mech.numbered if own[link]]


def _one_link(links: list[str], mech: Mechanism) -> Words:
    driven = next((name for name in mech.numbered if not set(mech.link(name).points) & set(mech.frame)), "2")
    example = (
        f"find: [P_{mech.number(driven)}{mech.number(FRAME)}, W_{mech.number(driven)}, delta_{mech.number(driven)}]"
    )
    if not links:
        return Words(f"没有要求的曲率；请写如 {example}", f"no curvature is asked; write e.g. {example}")
    names = "、".join(links)
    return Words(
        f"所求的量属于几个构件（{names}）；一题只求一个构件的曲率，请分成几题",
        f"what is asked belongs to several links ({', '.join(links)}); one problem asks curvatures of one link: "
        "write several",
    )


def centrode_asks(mech: Mechanism, centrodes: Centrodes) -> tuple[AskNamed, ...]:
    """How long both centrodes are."""
    return tuple(AskNamed(rel=named) for named in centrode_lengths(mech, centrodes.link))


def known_quantities(forces: Mapping[str, Named], centrodes: Centrodes | None, mech: Mechanism) -> dict[str, Named]:
    """What may be asked or printed, the centrodes included where they are drawn."""
    extra = centrode_lengths(mech, centrodes.link) if centrodes is not None else ()
    return {**forces, **{named.key: named for named in extra}}
