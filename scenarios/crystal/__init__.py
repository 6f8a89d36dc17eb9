"""Growth of crystals from a melt."""
