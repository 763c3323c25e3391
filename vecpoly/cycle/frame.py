"""The columns of a cycle as numpy arrays in SI, or as a pandas DataFrame where pandas is there."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MissingPackageError
from ..words import Words

if TYPE_CHECKING:
    from .cycle import Cycle


def arrays(cycle: Cycle, keys: tuple[str, ...]) -> dict[str, NDArray[Any]]:
    """Key → values at every position, SI: the drive's position, then these columns (or all); vectors are complex."""
    names = keys or tuple(column.key for column in cycle.columns)
    return {key: np.asarray(cycle.column(key)) for key in dict.fromkeys((cycle.drive.key, *names))}


def frame(cycle: Cycle, keys: tuple[str, ...]) -> Any:
    """The same as a DataFrame over the drive's position; a vector is two columns. Raises MissingPackageError."""
    try:
        import pandas
    except ImportError:
        raise MissingPackageError(
            Words(
                "to_frame 需要 pandas（pip install pandas）；不用 pandas 时请用 arrays()",
                "to_frame needs pandas (pip install pandas); without it take arrays()",
            ),
            code="no package",
        ) from None
    first, *rest = arrays(cycle, keys).items()
    columns: dict[str, NDArray[Any]] = {}
    for key, values in rest:
        columns |= {f"{key}.x": values.real, f"{key}.y": values.imag} if np.iscomplexobj(values) else {key: values}
    return pandas.DataFrame(columns, index=pandas.Index(first[1], name=first[0]))
