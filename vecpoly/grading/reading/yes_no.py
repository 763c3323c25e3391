"""Yes and no, in the words of what is asked: 自锁, not balanced, 失真, 不满足."""

from __future__ import annotations

import re

_YES = {"是", "有", "对", "√", "✓", "✔", "yes", "y", "true"}
_NO = {"否", "不", "错", "无", "no", "n", "false"}
_WORDS = (
    r"是|能|会|存在|自锁|平衡|静平衡|动平衡|满足|合格|符合(?:要求)?|确定|失真|根切|"
    r"self-?\s?locking|(?:statically |dynamically )?balanced|satisfied|met|determined|undercut"
)
_SAID = re.compile(rf"(?P<no>不|未|没有|无|非|没|not |un|in)?(?:能|会|可|发生|产生|已|有)?(?:{_WORDS})", re.I)


def yes_or_no(text: str) -> bool | None:
    """Yes, no, or None where it is neither."""
    bare = text.strip().strip(".。!！").lower()
    if bare in _YES or bare in _NO:
        return bare in _YES
    found = _SAID.fullmatch(bare)
    return None if found is None else found["no"] is None
