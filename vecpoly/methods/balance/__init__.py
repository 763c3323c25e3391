"""Full balance of a linkage by counterweights: masses passed on to the frame, a mass–radius polygon a counterweight."""
