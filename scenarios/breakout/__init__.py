"""The breakout of the casting machine."""
