"""Smoothing kernels, compensated sums, labels, motion, and the barrier of the CPU's threads."""
