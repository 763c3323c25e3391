"""The printed question sheet, laid out so that a photograph of it can be measured."""
