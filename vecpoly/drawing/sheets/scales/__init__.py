"""Which scales figures are drawn to: as large as fills few sheets, smaller where details would find no room."""
