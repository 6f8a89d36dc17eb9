"""What a scenario is, its case, and its checks."""
