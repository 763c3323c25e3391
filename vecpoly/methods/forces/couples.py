"""The couples that act on a link, by their symbols: given ones, inertia couples, those that slides pass on."""

from __future__ import annotations

from collections.abc import Collection, Iterator

from ...mechanism.asked.forces import load_named
from ...mechanism.loads import Moment
from ...plane import Reals
from .lines.letters import slide_couple
from .state import Statics


def couples_on(st: Statics, link: str, *, within: Collection[str] = ()) -> Iterator[tuple[str, Reals]]:
    """Symbol and size (N·m, counter-clockwise positive) of the known couples;
    friction couples of pins are no couples of their own.

    within: links drawn together with this one; what slides pass on between them is an inner couple and left out.
    """
    inner = {st.named(other, link).symbol for other in within if other != link}
    for load in st.sized(link):
        if isinstance(load, Moment):
            yield load_named(load).symbol, st.size_of(load)
    if link in st.inertia_couples:
        yield f"M_{{I{link}}}", st.inertia_couples[link]
    for force in st.reactions(link):
        if force.named.symbol not in inner:
            yield slide_couple(force.named.symbol), force.couple
