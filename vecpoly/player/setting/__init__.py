"""Letters, lines and fonts as the page has them."""
