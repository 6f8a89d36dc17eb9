"""Bonds, elasticity and contact of solids."""
