"""The slips that could have made a printed column wrong, each tried."""
