"""What stands on a sheet beside its figures: the title block, the results, the red box of a warning."""
