"""Particles as points of mass that attract and repel each other, in double precision."""
