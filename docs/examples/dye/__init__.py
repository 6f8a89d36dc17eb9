"""A term from beginning to end: dye that diffuses. Kernels, the term, and a scenario that uses it."""
