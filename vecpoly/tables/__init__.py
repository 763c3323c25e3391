"""Tables as they are handed in: a regular file of a size that can be looked through, a workbook that is whole and does
not burst, comma-separated values of any program. Whoever reads one says as which error a fault is told."""
