"""Provers of inequalities for every n: signs, bounds, peaks, growth."""
