"""Heat that is conducted in bodies at rest."""
