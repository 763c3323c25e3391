"""高副低代: the chain with lower pairs only."""

from __future__ import annotations

from ....devices.structure_pairs import Chain, Form, Pair


def without_high_pairs(chain: Chain) -> Chain:
    """Every higher pair as a link with two lower pairs, at the centres of curvature;
    of gears on the line of action at 20°."""
    links, pairs = list(chain.links), []
    for i, pair in enumerate(chain.pairs):
        if pair.form.is_lower:
            pairs.append(pair)
            continue
        name = f"{pair.letter}*"
        links.append(name)
        pairs += [_end(pair, end, name, f"{pair.letter}{i}{end}") for end in (0, 1)]
    return Chain(tuple(links), tuple(pairs))


def _end(pair: Pair, end: int, name: str, letter: str) -> Pair:
    centre = pair.about[end]
    if centre is None:
        return Pair(letter=letter, form=Form.P, links=(name, pair.links[end]), at=pair.at, along=1j * pair.normal)
    if pair.form is Form.G:
        away = pair.at - centre  # r cos 20° on the radius turned by 20°
        centre += away * (0.9396926207859084 + 0.3420201433256687j) * 0.9396926207859084
    return Pair(letter=letter, form=Form.R, links=(pair.links[end], name), at=centre)
