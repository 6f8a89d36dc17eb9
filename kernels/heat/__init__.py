"""Conduction, and the switch of phase."""
