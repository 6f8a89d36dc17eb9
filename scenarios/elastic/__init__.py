"""Elastic bodies without melt or heat."""
