"""Every limit on what is read and written, in one place; docs/limits.md tells them to people.

They are far above what an exercise needs, and low enough that no file, however it came about, keeps anybody waiting.
"""

from __future__ import annotations

# Problem files
FILE = 1_000_000  # bytes; a problem file has about a thousand
DEPTH = 40  # levels of lists and mappings within each other
SCALAR = 200  # characters of a value or a key
PROSE = 4_000  # characters of a statement, source, erratum or note
ENTRIES = 200  # of one list or mapping: links, joints, questions, printed answers
EXTENDS = 20  # files that extend each other
ECHO = 80  # characters of a value that a message repeats
FAULTS = 20  # of one file that a message lists; programs get all

# Numbers
MOST, LEAST = 1e20, 1e-20  # of any number; of any quantity in SI
MOST_ANGLE = 1e6  # rad
MOST_LENGTH = 1e6  # m, of links and of the places of fixed points
POWER = 9  # of a unit: m^9
UNSURE_ANGLE = 7.0  # rad: an angle written in rad that is larger was perhaps meant in degrees
ROUGH = 1.0  # coefficient of friction above which nothing slides on anything in a machine

# Variants
GRID = 10_000  # values of one range
ROSTER = 200_000  # students of one assignment
PERSON = 50  # characters of a number, a name, a class: they stand in a line of the page, and in a file's name

# Drawings
SMALL = 20.0  # mm that the mechanism should measure on paper at least
PAPER = (1e-2, 1e5)  # mm that a mechanism may measure on it at all, at the scale that is given
SHEET = (277.0, 190.0)  # mm of a landscape sheet that may be drawn on

# Printed tables
TABLE_BYTES = 20_000_000  # of a file
TABLE_UNPACKED = 200_000_000  # bytes of the parts of an XLSX file together
TABLE_ROWS = 20_000  # three for every tenth of a degree
TABLE_COLUMNS = 200
CELL = 1_000  # characters
LONG_READ = 200_000  # bytes of a table above which it is said that it is being read

# Hands
REPEATS = 100_000  # of a drawing
SEED = 2**63 - 1

# The cycle
POSITIONS = 2_000_001  # of the drive in a table
CENTRODES = (4, 24)  # positions through which a centrode is drawn

# Drawings of students
DRAWING_BYTES = 20_000_000  # of a file
DRAWING_UNPACKED = 100_000_000  # bytes, of what is packed in it
DRAWN = 20_000  # lines, heads and texts; a solved sheet has some hundreds
DRAWING_SPAN = 1e5  # mm from the origin
DRAWING_NESTED = 16  # blocks or groups within each other
DRAWING_PAGES = 20  # of a PDF
