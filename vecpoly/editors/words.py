"""What each key of a design project and of a search means, in both languages."""

from __future__ import annotations

PROJECT = {
    "id": "编号 / the name of the project on its sheets",
    "title": "题目 / title",
    "statement": "题目与要求 / the task in words",
    "source": "出处 / source",
    "title_block": "标题栏 / entries of the title block",
    "schemes": "供选择的方案：name、merits、faults、chosen / schemes to choose from: name, merits, faults, chosen",
    "parts": "各部分，每一部分是一道题目 / the parts, each a problem",
    "demands": "设计要求，如 linkage.gamma_min >= 40 deg / demands, e.g. linkage.gamma_min >= 40 deg",
    "of": "取用哪一部分所得的机构 / the part whose linkage is taken",
    "round": "杆长圆整到多少，如 1 mm / to what the lengths are rounded, e.g. 1 mm",
    "also": "另外作图的位置 / further positions that are drawn",
    "works": "只作用于一部分行程的载荷 / a load that acts on a part of a stroke only",
    "unevenness": "许用不均匀系数，如 1/20 / the coefficient of speed fluctuation, e.g. 1/20",
    "load": "载荷的名称 / the name of the load",
    "from": "自行程的百分之几起 / from which share of the stroke",
    "to": "到行程的百分之几止 / to which share of the stroke",
}
SEARCH = {
    "title": "题目 / title",
    "search": "所求：path 轨迹，dwell 间歇，transmission 最佳传动角 / what is sought",
    "data": "所求的数据 / the data of what is sought",
    "candidates": "试取多少个机构 / how many candidates are tried",
    "points": "轨迹上的点 / points of the curve",
    "closed": "轨迹是否封闭 / whether the curve is closed",
    "gamma_min": "最小传动角的许用值 / the minimum transmission angle admitted",
    "longest": "最长杆的许用值 / the longest link admitted",
    "dwell": "间歇对应的曲柄转角 / the turn of the crank during which the output rests",
    "swing": "从动件的摆角（或其范围） / the swing of the output, or its range",
    "AB": "曲柄长 / the crank",
    "K": "行程速比系数 / coefficient of the quick return",
    "CD": "摇杆长 / the rocker",
}
