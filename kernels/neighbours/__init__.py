"""Cells, sorting, and the lists of neighbours."""
