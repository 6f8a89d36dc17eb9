"""What runs on the device: one file per term of the equations. Knows arrays and numbers, nothing else."""
