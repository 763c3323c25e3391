"""Kinematic diagrams of their own sort, known by their titles: a legend names their lines otherwise."""

from __future__ import annotations

from ...words import Words

ALONG_AXIS = Words("轴向简图", "The rotor along its axis")
CRANKSHAFT = Words("曲轴轴向简图", "The crankshaft along its axis")
CURVATURES, SMALLER_CURVATURES = Words("曲率作图", "Curvatures"), Words("曲率作图（缩小）", "Curvatures, reduced")
SUMS_OF_LENGTHS = Words("杆长之和", "Sums of lengths")
SYNTHESIS = Words("机构的综合", "Synthesis of the linkage")
