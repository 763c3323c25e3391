"""Why what is wrong is wrong: one cause for as many values as it explains, and none where two would do."""

from __future__ import annotations

from collections.abc import Collection, Sequence

from ...board.otherwise.slip import Slip
from ..compare.band import target_of
from ..compare.outcome import Basis, Outcome
from ..key import Graded
from ..slips.mutants import Mutant
from ..slips.single import explanations, is_value_of
from ..slips.whole import agrees, explain
from ..told.message import Message, message
from ..told.named import Told
from ..told.slip import either, told_of
from .factors import of_factors
from .verdict import Verdicts
from .why import Causes

FAR = -2  # powers of ten
MANY = 3  # times as much wrong as a mistake explains: too much to name it
_BY_ITSELF = (Told.SWAPPED, Told.ZERO)  # what is said of one quantity, and is no mistake that two have in common


def causes(found: Verdicts, mutants: Sequence[Mutant]) -> Causes:
    """Find the cause of every root; what one cause explains beside its root is right by it (`basis`)."""
    why = Causes()
    _exchanged(found, why, mutants)
    for one in found.roots():
        if one.key in why.said or found.basis.get(one.key):
            continue
        _of_mistake(found, why, one, mutants, whole=True)
        if one.key not in why.said and not why.said:
            of_factors(found, why)
        if one.key not in why.said and not found.basis.get(one.key):
            _of_mistake(found, why, one, mutants)
        if one.key not in why.said and not found.basis.get(one.key):
            _of_itself(found, why, one)
    return why


def _of_mistake(found: Verdicts, why: Causes, root: Graded, mutants: Sequence[Mutant], *, whole: bool = False) -> None:
    """A mistake of the catalogue that explains the whole sheet, or else, beside what is right, the root alone."""
    if _a_single_sense(found, root) or _turned_alone(found, root):
        return
    open_ones = [one.key for one in found.roots() if one.key not in why.said and not found.basis.get(one.key)]
    settled = {name for name in found.given if name in why.said or name in why.source}
    pool = set(found.given) - settled if whole else _near(found, root)
    explained = explain(found.key, found.given, pool, [one for one in mutants if not _denied(found, root, one)])
    made = explained.mutant
    if made is not None and (root.key in made.lost or _outvoted(found, made)):
        return
    rivals = _rivals(found, root, open_ones, made) if made is not None else ()
    if any(map(_far_smaller, rivals)):
        return
    if rivals or explained.several:
        why.said[root.key] = message(Told.TWO_SLIPS)
    elif made is not None:
        at = _made_at(found, made.slip, open_ones) or root.key
        why.said[at], why.slips[at] = told_of(made.slip, made.also), made.slip
        _spread(found, why, at, open_ones, made)


def _denied(found: Verdicts, root: Graded, mutant: Mutant) -> bool:
    """Whether something on which the root rests was written otherwise than the mistake makes it: nobody who wrote
    θ = 12.6° had 45° from a formula without K, whatever agrees with that further on."""
    moved = (found.key[name] for name in found.key.below(root) if name in found.given and name in mutant.values)
    return any(not agrees(one, found.given[one.key], mutant, found.key.allowance) for one in moved)


def _made_at(found: Verdicts, slip: Slip, open_ones: Collection[str]) -> str | None:
    """The wrong quantity with which the mistake was made, where it was written down and is paid: there it costs."""
    key = slip.key.rpartition(":")[2]
    return key if key in open_ones and found.key[key].points.method else None


def _rivals(found: Verdicts, root: Graded, open_ones: Collection[str], made: Mutant) -> tuple[Message, ...]:
    """The other explanations of a single wrong value; another vector taken for it is none beside a mistake that was
    made with the very quantity."""
    if len(open_ones) > 1 or found.outcome[root.key] is not Outcome.WRONG:
        return ()
    said = explanations(root, found.given[root.key], target_of(root), found.key)
    return tuple(one for one in said if one.id is not Told.SWAPPED or made.slip.key != root.key)


def _outvoted(found: Verdicts, made: Mutant) -> bool:
    """Whether far more is wrong than the mistake explains: one of many values that are wrong otherwise agrees with some
    mistake by chance."""
    wrong = [*found.roots(), *(found.key[name] for name, basis in found.basis.items() if basis is Basis.SCALE)]
    wrong = [one for one in wrong if one.key not in made.lost]
    borne_out = sum(agrees(one, found.given[one.key], made, found.key.allowance) for one in wrong)
    return len(wrong) > MANY * borne_out


def _far_smaller(rival: Message) -> bool:
    """Whether it is a power of ten by which T is so much smaller that hardly anything else comes as near."""
    return rival.id is Told.POW10 and int(str(rival.numbers["n"])) <= FAR


def _a_single_sense(found: Verdicts, root: Graded) -> bool:
    """Whether one sense is all that is wrong: whoever lays off a vector the wrong way has more than one reversed."""
    reversed_ones = [name for name, outcome in found.exact.items() if outcome is Outcome.SENSE]
    return found.outcome[root.key] is Outcome.SENSE and len(reversed_ones) < 2


def _turned_alone(found: Verdicts, root: Graded) -> bool:
    """Whether a size follows from own values, so that only its sense or direction is wrong."""
    return found.exact[root.key] is Outcome.WRONG and found.outcome[root.key] is not Outcome.WRONG


def _near(found: Verdicts, root: Graded) -> set[str]:
    """The root, and all that is right by the exact values: also what rests on the root, for it is right by no mistake
    that would have moved it."""
    return {root.key} | {name for name, outcome in found.exact.items() if outcome.is_right and name in found.given}


def _spread(found: Verdicts, why: Causes, root: str, open_ones: Sequence[str], mutant: Mutant) -> None:
    """What the same mistake makes wrong, or less than right, costs nothing more."""
    close = [name for name, outcome in found.outcome.items() if outcome is Outcome.CLOSE and name not in why.source]
    for name in (*open_ones, *close):
        if name == root or not (name in mutant.values or mutant.leaves_out(name)) or _nothing(found, name):
            continue
        if agrees(found.key[name], found.given[name], mutant, found.key.allowance):
            found.outcome[name], found.basis[name], why.source[name] = Outcome.RIGHT, Basis.SLIP, root


def _nothing(found: Verdicts, name: str) -> bool:
    """Whether 0 was written of what is not 0: that follows from no mistake with another quantity."""
    mine = found.given[name]
    return mine.at is None and mine.yes is None and not mine.value and bool(found.key[name].exact)


def _exchanged(found: Verdicts, why: Causes, mutants: Sequence[Mutant]) -> None:
    """Two values of which each is that of the other, where nothing else is wrong: their names were exchanged, or a
    mistake was made that gives just this, as α and γ of a force turned by 90°; then both are told, and it costs once.
    """
    pair = found.roots()
    if len(pair) != 2 or any(found.outcome[one.key] is not Outcome.WRONG for one in pair):
        return
    first, second = pair
    if not (_is_of(found, first, second) and _is_of(found, second, first)):
        return
    made = explain(found.key, found.given, set(found.given), mutants).mutant
    if made is None:
        why.said |= {one.key: message(Told.SWAPPED, other=other.symbol) for one, other in (pair, pair[::-1])}
        return
    ways = either((made.slip, *made.also))
    why.said[first.key] = message(Told.EXCHANGED, other=second.symbol, ways=ways, slip=str(made.slip))
    found.outcome[second.key], found.basis[second.key] = Outcome.RIGHT, Basis.SLIP
    why.source[second.key] = first.key


def _is_of(found: Verdicts, one: Graded, other: Graded) -> bool:
    return is_value_of(found.given[one.key], one, other)


def _of_itself(found: Verdicts, why: Causes, root: Graded) -> None:
    """A power of ten, 2π, another vector's value: from the exact value, or from what follows from own ones."""
    if found.outcome[root.key] is not Outcome.WRONG:
        return
    targets = [target_of(root)]
    if (followed := found.followed.get(root.key)) is not None and followed.target is not None:
        targets.append(followed.target)
    for target in targets:
        said = explanations(root, found.given[root.key], target, found.key)
        if len({(one.id, *one.numbers.items()) for one in said}) == 1:
            before = next(
                (
                    name
                    for name, one in why.said.items()
                    if one == said[0] and one.id not in _BY_ITSELF and _alike(found.key[name], root)
                ),
                None,
            )
            if before is not None:
                found.outcome[root.key], found.basis[root.key] = Outcome.RIGHT, Basis.SLIP
                why.source[root.key] = before
            else:
                why.said[root.key] = said[0]
            return
        if said:
            why.said[root.key] = message(Told.TWO_SLIPS)


def _alike(first: Graded, second: Graded) -> bool:
    """Whether one mistake with a unit or a scale may be in both: none that lengths have in common is in an angle."""
    return first.block == second.block and (first.unit == "deg") is (second.unit == "deg")
