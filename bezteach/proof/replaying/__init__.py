"""Proofs checked again from their certificates, without the search that found them."""
