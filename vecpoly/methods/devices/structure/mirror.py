"""Redundant constraints of a symmetric half (对称部分):
two equal and opposite trains that move one slide, coupled a second time."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from ....devices.structure_pairs import FRAME, Chain, Form, Pair
from ....names import subscripted
from ....words import Words
from .parallel import Found


def mirrored(chain: Chain, near: float, drivers: tuple[str, ...]) -> Iterator[Found]:
    """The half without the driver,
    where the whole chain is its own mirror image in the line of a slide on the frame."""
    for slide in chain.pairs:
        if slide.form is not Form.P or FRAME not in slide.links:
            continue
        image = _image(chain, slide, near)
        half = tuple(link for link in chain.links if image.get(link, link) != link and _aside(chain, link, slide) < 0)
        halves = [half, tuple(link for link in chain.links if image.get(link) in half)]
        for links in sorted(halves, key=lambda links: len(set(links) & set(drivers))):
            spare = tuple(link for link in links if link not in drivers)
            rods = tuple(
                link
                for link in spare
                if len(chain.at(link)) == 2 and all(pair.form is Form.R for pair in chain.at(link))
            )
            yield from (
                (part, _why(part, tuple(image[link] for link in part), slide)) for part in (rods, spare) if part
            )


def _why(links: tuple[str, ...], others: tuple[str, ...], slide: Pair) -> Words:
    axis = subscripted(slide.letter)
    s = "s" * (len(links) > 1)
    return Words(
        f"构件 {'、'.join(links)} 与构件 {'、'.join(others)} 关于移动副 ${axis}$ 的导路中线对称布置，尺寸相同，"
        "为受力均衡而重复设置，对运动不起独立的约束作用",
        f"link{s} {', '.join(links)} {'are' if s else 'is'} the mirror image of link{s} "
        f"{', '.join(others)} in the line of prismatic joint ${axis}$, with the same sizes: there to balance "
        "the forces, adding nothing to the motion",
    )


def _image(chain: Chain, slide: Pair, near: float) -> Mapping[str, str]:
    """Each link and its mirror image; empty where the chain is not symmetric."""
    image: dict[str, str] = {FRAME: FRAME}
    for link in chain.links:
        like = [other for other in chain.links if _alike(chain.at(link), chain.at(other), slide, near)]
        if len(like) != 1:
            return {}
        image[link] = like[0]
    whole = all(
        any(_is_image(p, q, slide, near) and {image[link] for link in p.links} == set(q.links) for q in chain.pairs)
        for p in chain.pairs
    )
    return image if whole else {}


def _alike(mine: tuple[Pair, ...], its: tuple[Pair, ...], slide: Pair, near: float) -> bool:
    return len(mine) == len(its) and all(any(_is_image(p, q, slide, near) for q in its) for p in mine)


def _is_image(p: Pair, q: Pair, slide: Pair, near: float) -> bool:
    """Whether a pair is the mirror image of another:
    the same form at the mirrored place, slides along the mirrored line."""
    if p.form is not q.form or abs(_mirror(p.at, slide) - q.at) > near:
        return False
    turned = slide.along**2 * p.along.conjugate()
    level = p.form is not Form.P or abs((turned.conjugate() * q.along).imag) < 1e-4
    centres = [_mirror(c, slide) for c in p.about if c is not None]
    its = [c for c in q.about if c is not None]
    return level and len(centres) == len(its) and all(any(abs(a - b) < 2 * near for b in its) for a in centres)


def _mirror(at: complex, slide: Pair) -> complex:
    return slide.at + slide.along**2 * (at - slide.at).conjugate()


def _aside(chain: Chain, link: str, slide: Pair) -> float:
    """On which side of the line a link lies, by the mean of its pairs."""
    return sum((slide.along.conjugate() * (pair.at - slide.at)).imag for pair in chain.at(link))
