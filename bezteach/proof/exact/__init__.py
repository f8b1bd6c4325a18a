"""The exact evaluator and the refuter: the judge of the provers, which shares nothing with them."""
