"""Expressions as sums of hypergeometric terms: sums closed, edges split off, and where everything has a value."""
