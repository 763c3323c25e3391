"""A description of every key of a load, in both languages."""

from __future__ import annotations

from ...words import Words

LOADS = {
    "LoadSpec.cylinder": Words("液压缸的推力，写其两构件：2-3", "the thrust of a cylinder, by its two links: 2-3"),
    "LoadSpec.on": Words("所作用构件的编号", "number of the link on which it acts"),
    "LoadSpec.at": Words("力的作用点（构件上的字母）", "the lettered point of the link at which a force acts"),
    "LoadSpec.size": Words(
        '大小：1000 N、20 N*m ccw；待求的写 "?"；一周期内不变的待求力矩写 constant（常数）；数据表写 {table: card.csv}',
        'size: 1000 N, 20 N*m ccw; "?" for the load that balances; constant for the unknown moment that is the same '
        "over the period; {table: card.csv} for one by a table",
    ),
    "LoadSpec.direction": Words(
        "力的方向，由 x 轴量起：180 deg；在原动件上也可写 沿 AB（随构件转动）",
        "direction of a force from the x axis: 180 deg; on the driving link also along AB, which turns with it",
    ),
    "LoadSpec.role": Words("驱动（driving）或阻力（resisting）", "what it is meant to do: driving or resisting"),
    "LoadSpec.while": Words(
        "仅在某点或某构件如此运动时作用：E 向左运动、E 沿 30 deg 运动、构件 3 逆时针转动",
        "acts only while a point or a link moves so: E moves left, E moves along 30 deg, 3 turns ccw",
    ),
    "LoadSpec.between": Words(
        "与 while 同用：在该行程的哪一段作用：[5 %, 95 %]", "with while: on which part of that stroke: [5 %, 95 %]"
    ),
    "LoadSpec.during": Words(
        "在原动件的哪一段作用：[60 deg, 150 deg]", "on which part of the drive's turn it acts: [60 deg, 150 deg]"
    ),
    "LoadSpec.motor": Words(
        "电动机的机械特性 M = a − b ω：[2400 N*m, 330 N*m*s]", "a motor, M = a - b omega: [2400 N*m, 330 N*m*s]"
    ),
    "LoadSpec.spring": Words(
        "两点间的弹簧 B-D，或两构件间的扭簧 1-4", "a spring between two points, B-D, or two links, 1-4"
    ),
    "LoadSpec.damper": Words(
        "两点间的阻尼器 B-D，或两构件间的 1-4", "a damper between two points, B-D, or two links, 1-4"
    ),
    "LoadSpec.k": Words("弹簧刚度：5 N/mm、2 N*m/rad", "stiffness of the spring: 5 N/mm, 2 N*m/rad"),
    "LoadSpec.l_0": Words("弹簧的自由长度：80 mm", "free length of the spring: 80 mm"),
    "LoadSpec.phi_0": Words("扭簧的自由角：30 deg", "free angle of the torsion spring: 30 deg"),
    "LoadSpec.preload": Words(
        "自由长度时的力（受压为负）：20 N、1 N*m", "what acts at the free length (pressing: negative): 20 N, 1 N*m"
    ),
    "LoadSpec.c": Words("阻尼系数：50 N*s/m、0.1 N*m*s", "coefficient of damping: 50 N*s/m, 0.1 N*m*s"),
    "TableSpec.table": Words(
        "题目文件旁的 CSV 文件，两列：phi (deg) 或 s (mm)；F (N)、M (N*m) 或 p (MPa)",
        "a CSV file beside this one, of two columns: phi (deg) or s (mm); F (N), M (N*m) or p (MPa)",
    ),
    "TableSpec.columns": Words("不用文件时的表头：[phi (deg), F (N)]", "the heads, without a file: [phi (deg), F (N)]"),
    "TableSpec.rows": Words(
        "不用文件时的各行：[[0, 100], [90, 250]]", "the rows, without a file: [[0, 100], [90, 250]]"
    ),
    "TableSpec.area": Words("压强所作用的活塞面积：5000 mm^2", "area on which the pressure acts: 5000 mm^2"),
    "TableSpec.bore": Words("活塞直径，代替面积：80 mm", "diameter of the piston, in the place of the area: 80 mm"),
}
