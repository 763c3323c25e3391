"""The commands of a class: variants, sheets, answers checked and marked."""
