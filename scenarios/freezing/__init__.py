"""Pure substances that freeze, at rest."""
