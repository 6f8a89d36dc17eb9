"""Result files, written and read."""
