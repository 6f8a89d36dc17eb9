"""What freezes at rest."""
