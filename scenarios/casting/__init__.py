"""The casting machine."""
