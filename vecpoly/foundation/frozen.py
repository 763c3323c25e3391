"""A mapping that nobody changes: it pickles, copies and hashes, which `types.MappingProxyType` does not."""

from __future__ import annotations

from collections.abc import ItemsView, Iterator, KeysView, Mapping, ValuesView
from typing import Any, TypeVar

K = TypeVar("K")
V = TypeVar("V")


class FrozenMap(Mapping[K, V]):
    """A copy of a mapping, in its order. Its hash is that of its items; raises TypeError where a value has none."""

    __slots__ = ("_held",)
    _held: dict[K, V]

    def __init__(self, items: Mapping[K, V]) -> None:
        object.__setattr__(self, "_held", dict(items))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError(f"a FrozenMap does not change: '{name}' cannot be set")

    def __getitem__(self, key: K) -> V:
        return self._held[key]

    def __iter__(self) -> Iterator[K]:
        return iter(self._held)

    def __len__(self) -> int:
        return len(self._held)

    def __contains__(self, key: object) -> bool:
        return key in self._held

    def keys(self) -> KeysView[K]:
        """The keys."""
        return self._held.keys()

    def values(self) -> ValuesView[V]:
        """The values."""
        return self._held.values()

    def items(self) -> ItemsView[K, V]:
        """The pairs."""
        return self._held.items()

    def __or__(self, other: Mapping[K, V]) -> dict[K, V]:
        return {**self._held, **other}

    def __hash__(self) -> int:
        return hash(frozenset(self._held.items()))

    def __repr__(self) -> str:
        return repr(self._held)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (dict(self._held),)
