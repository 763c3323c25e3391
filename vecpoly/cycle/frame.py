"""Columns over a cycle as a pandas DataFrame, where pandas is there."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..errors import MissingPackageError
from ..words import Words


def frame(arrays: Mapping[str, NDArray[Any]]) -> Any:
    """A DataFrame over the first of these arrays; a vector is two columns, v_C.x and v_C.y. Raises
    MissingPackageError."""
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
    (name, places), *rest = arrays.items()
    columns: dict[str, NDArray[Any]] = {}
    for key, values in rest:
        columns |= {f"{key}.x": values.real, f"{key}.y": values.imag} if np.iscomplexobj(values) else {key: values}
    return pandas.DataFrame(columns, index=pandas.Index(places, name=name))
