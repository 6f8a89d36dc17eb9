"""A weakly compressible flow whose sums are corrected by the moment matrix: two sweeps a step, one over the walls."""
