"""Problems, solutions and constructions as a notebook shows them:
HTML and SVG in the reader's language, their letters outlined."""
