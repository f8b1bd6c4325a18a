"""Provers of equations for every n: ratio of terms and binomial theorem, WZ certificates, induction."""
