"""The vorticity of a flow, found from the velocities of its particles."""

import numpy as np
from scipy.spatial import cKDTree

from warpsph.core.quantity import Quantity
from warpsph.pictures.parts import BESIDE_THE_FLUID, Fields

NAME = "vorticity"
QUANTITY = Quantity(NAME, "1/s", "RdBu_r")
NEIGHBOURS = {2: 13, 3: 33}  # two rings around a particle of a lattice, and itself


def vorticity(points: np.ndarray, fields: Fields) -> np.ndarray:
    """Curl of the velocity [1/s]: its z component (n,) in the plane, all three (n, 3) in space; 0 beside the fluid.

    From the gradient of a velocity that is linear around each particle, by weighted least squares: exact for linear
    velocities, also at walls and at a free surface.

    Args:
        points: places (n, 3) [m].
        fields: with the velocity (n, 3) [m/s] and the role (n,).
    """
    in_plane = not np.any(points[:, 2])
    dimension = 2 if in_plane else 3
    curl = np.zeros((len(points), 3))
    fluid = np.flatnonzero(~np.isin(fields["role"], BESIDE_THE_FLUID))
    count = NEIGHBOURS[dimension]
    if len(fluid) >= count:
        x, u = points[fluid, :dimension].astype(float), fields["velocity"][fluid].astype(float)
        distance, near = cKDTree(x).query(x, count)
        way, change = x[near] - x[:, None], u[near] - u[:, None]
        weight = np.exp(-2.0 * (distance / np.maximum(distance[:, -1:], 1e-30)) ** 2)
        moment = np.einsum("nk,nka,nkb->nab", weight, way, way)
        slope = np.einsum("nk,nka,nkb->nab", weight, way, change)  # of u_b along a, times the moment
        G = np.zeros((len(fluid), 3, 3))
        G[:, :dimension] = np.linalg.pinv(moment, hermitian=True) @ slope
        curl[fluid] = np.stack([G[:, 1, 2] - G[:, 2, 1], G[:, 2, 0] - G[:, 0, 2], G[:, 0, 1] - G[:, 1, 0]], axis=1)
    return curl[:, 2] if in_plane else curl
