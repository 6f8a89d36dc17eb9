"""A run: clock, output, progress, diagnostics."""
