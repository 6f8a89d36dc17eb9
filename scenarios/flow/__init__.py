"""Fluids at rest, in motion, and with a surface."""
