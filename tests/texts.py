"""Problem texts and equations that several test files start from."""

from __future__ import annotations

from vecpoly.board.construction import EquationTable
from vecpoly.words import Words

SLIDER_CRANK = """\
id: t
title: test
frame: {A: [0 mm, 0 mm]}
links:
  1: {AB: 80 mm}
  2: {BC: 230 mm}
  3: {block: C}
joints: [3 slides on y = -15 mm]
"""

CRANK = """\
id: t
title: test
frame: {A: [0 mm, 0 mm]}
links: {1: {AB: 30 mm}, 2: {BC: 100 mm}, 3: {block: C}}
joints: [3 slides on y = 0 mm]
branch: [C right of A]
input: {link: 1, phi: 50 deg, omega: 10 rad/s ccw}
find: [v_C]
"""

SIX_BAR = """
id: six-bar
title: six-bar
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm], F: [320 mm, 60 mm]}
links: {1: {AB: 50 mm}, 2: {BC: 170 mm}, 3: {DC: 130 mm}, 4: {CE: 150 mm}, 5: {FE: 100 mm}}
input: {link: 1, phi: 70 deg, omega: 5 rad/s ccw}
branch: [C left of BD, E left of CF]
loads: {M_5: {on: 5, size: 10 N*m}, M_1: {on: 1, size: "?"}}
"""

CLASS_III = """\
id: c3
title: {zh: Ⅲ 级六杆机构, en: A six-bar linkage of class III}
frame: {A: [0 mm, 0 mm], D: [200 mm, 0 mm], G: [100 mm, 250 mm]}
links:
  1: {AB: 50 mm}
  2: {BC: 120 mm}
  3: {CE: 80 mm, F: {CF: 80 mm, EF: 80 mm, side: left of CE}}
  4: {ED: 110 mm}
  5: {FG: 120 mm}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
guesses: {C: [80 mm, 120 mm], E: [160 mm, 110 mm], F: [120 mm, 180 mm]}
find: [v_C, omega_3]
"""
CLASS_IV = """\
id: iv
title: class IV
frame: {A: [0 mm, 0 mm], G: [200 mm, 0 mm]}
links:
  1: {AB: 40 mm}
  2: {BC: 80 mm, D: {BD: 90 mm, CD: 70 mm, side: left of BC}}
  3: {CE: 80 mm}
  4: {DF: 80 mm}
  5: {GE: 100 mm, F: {GF: 110 mm, EF: 70 mm, side: left of GE}}
input: {link: 1, phi: 60 deg, omega: 10 rad/s ccw}
guesses: {C: [80 mm, 80 mm], D: [40 mm, 120 mm], E: [160 mm, 80 mm], F: [160 mm, 120 mm]}
find: [v_C, omega_3]
"""

ZH = (
    "图示**铰链四杆机构**中，已知各构件的尺寸及原动件 $AB$ 以等角速度 $ω_1$ 逆时针转动，试用矢量方程图解法"
    "求构件 $BC$ 的角速度 $ω_2$（比例尺 $μ_l$）。选取“速度比例尺”，由极点作垂线，代表《速度》；"
    "方向如图所示——这就是所求。学生：陈喆、王堃。"
)


def equation(terms: int = 3) -> EquationTable:
    """v_C = v_B + v_CB + ... with so many terms."""
    return EquationTable(
        symbols=("v_C", "v_B", *("v_CB",) * (terms - 2)),
        signs=("", "=", *("+",) * (terms - 2)),
        directions=(Words("∥ 导路", "∥ guide"), *(Words("⊥$AB$", "⊥$AB$"),) * (terms - 1)),
        magnitudes=("?", *("$ω_1 l_{AB}$",) * (terms - 1)),
    )
