"""Solids of particles that attract and repel each other, and melt."""
