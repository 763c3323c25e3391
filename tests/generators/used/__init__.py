"""What is done with a solved problem, done with any member of any family: told anew, read otherwise, varied, drawn,
exported, played, reported, graded, taken through its cycle. A use may be refused in words; it may not break off, warn
on the terminal, or say something else than the solution."""

from . import changed as changed
from . import kept as kept
from . import shown as shown
from . import whole as whole
