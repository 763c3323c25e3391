"""What groups are called that are no Assur groups of lower pairs."""

from __future__ import annotations

from ....words import Words

ROLLING = {"gear": Words("齿轮", "gear"), "rack": Words("齿条", "rack"), "gear train": Words("轮系", "gear train")}
