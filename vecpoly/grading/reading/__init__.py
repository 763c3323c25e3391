"""What a student wrote: numbers, units, senses, symbols, in any of the ways in which people write them."""
