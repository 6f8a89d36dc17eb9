"""What the parts of a casting machine do to particles."""
