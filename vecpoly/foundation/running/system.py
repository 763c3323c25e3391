"""What the operating system refuses, in words."""

from __future__ import annotations

import errno

from ...words import Words

_SYSTEM = {
    errno.ENOENT: "没有此文件或文件夹",
    errno.EACCES: "没有权限",
    errno.EPERM: "没有权限",
    errno.EEXIST: "已存在，不会覆盖；请换一个名称",
    errno.EISDIR: "是文件夹；请给出其中的文件名",
    errno.ENOTDIR: "是文件而不是文件夹；请另选位置",
    errno.ENOSPC: "磁盘已满",
    errno.EROFS: "是只读的",
    errno.ENAMETOOLONG: "名称过长",
    errno.EIO: "读写错误",
    errno.EMFILE: "打开的文件过多",
}


def of_system(error: OSError) -> Words:
    """What the operating system refuses, in both languages."""
    en = error.strerror or str(error) or type(error).__name__
    return Words(_SYSTEM.get(error.errno or 0, en), en)
