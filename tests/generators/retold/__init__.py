"""Members of other families told otherwise: in other units and signs, other letters, another frame, a mirror. The
answers stay, turn, or are mirrored."""

from __future__ import annotations

from . import asked as asked
from . import cycled as cycled
from . import extended as extended
from . import moved as moved
from . import renamed as renamed
from . import signs as signs
from . import units as units
