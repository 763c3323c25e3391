"""What is asked of a mechanism that is still to be found: the data of each task of synthesis, one file each."""
