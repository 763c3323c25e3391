"""An epicyclic train in words."""

from __future__ import annotations

from collections.abc import Collection

from ...words import Words


def train_task(asked: Collection[str], *, stepped: bool, ring: bool) -> Words:
    """Which gears mesh on which carrier; asked: the keys of what is asked."""
    other = Words("内齿轮 3", "ring 3") if ring else Words("太阳轮 3", "sun 3")
    planet = (
        Words(
            "双联行星轮 2–2′ 的 2 与太阳轮 1 啮合，2′ 与", "of a stepped planet 2–2′, 2 meshes with sun 1 and 2′ with"
        )
        if stepped
        else Words("行星轮 2 与太阳轮 1 和", "planet 2 meshes with sun 1 and with")
    )
    points = _points(asked)
    first = Words("第一对齿轮的", " of the first pair") if stepped else Words("", "")
    return Words(
        f"周转轮系中，{planet.zh}{other.zh} 啮合，$O_2$ 为行星轮轴心，$H$ 为系杆；$z_i$ 为轮 $i$ 的齿数，$m$ 为"
        f"{first.zh}模数，$ω_i$ 为构件 $i$ 的角速度，逆时针为正，固定的构件为 0{points.zh}。",
        f"In an epicyclic train {planet.en} {other.en}; $O_2$ is the planet's centre, $H$ the carrier. Gear $i$ has "
        f"$z_i$ teeth, $m$ is the module{first.en}; the angular velocity $ω_i$ of link $i$ counts positive "
        f"counter-clockwise, and is 0 where the link stands still{points.en}.",
    )


_AT = {
    "v_A": Words("$A$ 为轮 1、2 的节点", "$A$ is the pitch point of the gears 1 and 2"),
    "v_C": Words("$C$ 为行星轮与轮 3 的节点", "$C$ is the pitch point of the planet and gear 3"),
}


def _points(asked: Collection[str]) -> Words:
    """Which point is which, where its speed is asked."""
    told = [words for key, words in _AT.items() if key in asked]
    return Words("".join(f"；{one.zh}" for one in told), "".join(f"; {one.en}" for one in told))
