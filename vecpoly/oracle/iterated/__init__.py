"""Groups of class III and higher, gear trains and inner drives: Newton on all loop equations at once."""
