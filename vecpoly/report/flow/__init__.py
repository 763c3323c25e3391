"""The report's own flowables on reportlab: paragraphs, formulas, equations, tables, figures, sheets."""

from __future__ import annotations

from .blocks import Callout, Divider, Drawing, Heading, SheetPage
from .cover import TITLE_FIELDS, TitleBlock
from .doc import Metadata, ReportDoc, Written
from .equation import EquationFlow
from .formula import Formula
from .para import Para, numbered
from .table import DataTable
from .xml import MarkupError, to_flowables

__all__ = [
    "TITLE_FIELDS",
    "Callout",
    "DataTable",
    "Divider",
    "Drawing",
    "EquationFlow",
    "Formula",
    "Heading",
    "MarkupError",
    "Metadata",
    "Para",
    "ReportDoc",
    "SheetPage",
    "TitleBlock",
    "Written",
    "numbered",
    "to_flowables",
]
