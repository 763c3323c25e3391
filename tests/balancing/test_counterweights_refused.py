"""What counterweights cannot balance is refused with the reason, and with what the best of them leaves."""

from __future__ import annotations

import numpy as np
import pytest

import vecpoly
from vecpoly.errors import ProblemFileError
from vecpoly.oracle import solve

FOUR_BAR = """
id: tried
title: {zh: 试, en: tried}
frame: {A: [0 mm, 0 mm], D: [260 mm, 0 mm]}
links:
  1: {AB: 80 mm}
  2: {BC: 240 mm}
  3: {CD: 180 mm}
input: {link: 1, phi: 60 deg, omega: 20 rad/s ccw}
branch: [C left of BD]
masses:
  2: {mass: 1.2 kg, centre: {along: BC, at: 120 mm, left: 50 mm}}
counterweights: {1: {r: 60 mm}, 3: {r: 100 mm}}
find: [m_c]
"""
YOKE = """
id: yoke
title: {zh: 正弦机构, en: Scotch yoke}
frame: {A: [0 mm, 0 mm]}
links:
  1: {AB: 60 mm}
  2: {block: B}
  3: {slot: C}
joints: [2 slides in 3, 3 slides on x = 0 mm turned -90 deg]
input: {link: 1, phi: 33 deg, omega: 30 rad/s ccw}
masses: {3: {mass: 4 kg}}
counterweights: {1: {r: 60 mm}}
find: [m_c1]
"""


def refusal(text: str) -> vecpoly.Words:
    """What is said of a file."""
    with pytest.raises(ProblemFileError) as caught:
        vecpoly.loads(text)
    return caught.value.words


def test_of_a_scotch_yoke_the_best_counterweight_leaves_half_turning_backwards() -> None:
    told = refusal(YOKE)
    assert "108 N of 216 N" in told.en and "0.12 kg·m" in told.en and "backwards" in told.en
    assert "216 N 中还剩 108 N" in told.zh


@pytest.mark.parametrize("lean", [90, 60])
def test_the_numbers_of_the_yoke_are_those_of_its_motion(lean: int) -> None:
    text = YOKE.replace("-90 deg", f"-{lean} deg").split("masses")[0] + "find: [a_C]\n"
    mech = vecpoly.loads(text).mechanism
    at = np.linspace(0, 2 * np.pi, 720, endpoint=False)
    force = -4 * solve(mech, at).moving("3", 2).acceleration
    most = float(np.abs(force).max())
    told = refusal(YOKE.replace("-90 deg", f"-{lean} deg")).en
    half, whole = (float(word.split(" N")[0].split("(")[-1]) for word in told.rsplit(" of ", 1))
    assert whole == pytest.approx(most, rel=1e-4)
    balanced = [np.abs(force - u * np.exp(1j * (at + shift))).max() for u in np.linspace(0, most, 41)
                for shift in np.linspace(0, 2 * np.pi, 120, endpoint=False)]  # fmt: skip
    assert half == pytest.approx(min(balanced), rel=2e-2)
    assert half <= min(balanced) * (1 + 1e-5)


def test_masses_that_go_round_in_a_circle_name_the_link_that_lacks_a_counterweight() -> None:
    told = refusal(FOUR_BAR.replace(", 3: {r: 100 mm}", ""))
    assert "links 2 and 3" in told.en and "link 2 or 3 a counterweight too" in told.en
    assert "构件 2、3" in told.zh


def test_a_rod_that_swings_on_one_hinge_wants_a_counterweight() -> None:
    told = refusal(
        FOUR_BAR.replace("2: {BC: 240 mm}", "2: {rod: B, S: {along: B, at: 60 mm}}")
        .replace("3: {CD: 180 mm}", "3: {block: D}")
        .replace("branch: [C left of BD]", "joints: [2 passes through 3]")
        .replace("centre: {along: BC, at: 120 mm, left: 50 mm}", "centre: S")
        .replace(", 3: {r: 100 mm}", "")
    )
    assert "link 2 is hinged at B alone" in told.en


@pytest.mark.parametrize(
    ("old", "new", "told"),
    [
        ("3: {r: 100 mm}", "4: {r: 100 mm}", "link 4 is the frame"),
        ("3: {r: 100 mm}", "7: {r: 100 mm}", "link '7' does not exist"),
        ("3: {r: 100 mm}", "3: {r: 0 mm}", "0 mm"),
        ("3: {r: 100 mm}", "3: {r: 5 kg}", "5 kg"),
        ("3: {r: 100 mm}", "3: {q: 5 mm}", "q"),
        ("2: {mass: 1.2 kg, centre: {along: BC, at: 120 mm, left: 50 mm}}", "2: {mass: 1.2 kg, centre: B}",
         "link 3 carries no mass"),
    ],
)  # fmt: skip
def test_what_is_written_wrongly_is_told_at_its_place(old: str, new: str, told: str) -> None:
    found = refusal(FOUR_BAR.replace(old, new))
    assert told in found.en
    assert "counterweights" in found.en


def test_no_masses_no_counterweights() -> None:
    head, tail = FOUR_BAR.split("masses:")
    assert "no link has a mass" in refusal(head + tail[tail.index("counterweights") :]).en


def test_a_slider_bears_no_counterweight() -> None:
    text = vecpoly.load("balance-slider-crank").text.replace("2: {r: 80 mm}", "3: {r: 80 mm}")
    assert "link 3 only translates" in refusal(text).en


def test_links_that_turn_together_have_no_single_answer() -> None:
    text = FOUR_BAR.replace("260 mm", "240 mm").replace("CD: 180 mm", "CD: 80 mm").replace("phi: 60", "phi: 61")
    with pytest.raises(vecpoly.VecpolyError, match="do not turn independently"):
        vecpoly.loads(text).solve()


def test_a_load_beside_counterweights_is_balanced_as_ever() -> None:
    text = FOUR_BAR.replace("find: [m_c]", "loads: {M: {on: 1, size: '?'}}\nfind: [m_c, M]")
    found = vecpoly.loads(text).solve(by="exact")
    alone = vecpoly.loads(
        text.replace("counterweights: {1: {r: 60 mm}, 3: {r: 100 mm}}", "").replace("m_c, ", "")
    ).solve(by="exact")
    assert found.answers["M"].drawn == pytest.approx(alone.answers["M"].drawn, rel=1e-9)
    assert found.answers["m_c"].drawn == pytest.approx(found.answers["m_c"].exact, rel=1e-9)
