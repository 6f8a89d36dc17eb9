"""Density, pressure, forces and surface tension of the fluid."""
