"""The blank frames of a question sheet: their sizes and places, what is given in them, lines to write on."""
