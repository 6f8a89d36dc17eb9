"""warpsph: particle simulation of solidification and continuous casting on NVIDIA Warp."""
