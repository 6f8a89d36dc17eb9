"""Which particles are solid: those that form a triangle of bonds with two others, all three of them calm."""

import warp as wp

from warpsph.kernels.basics.labels import Phase
from warpsph.kernels.neighbours.pairs import NeighbourList, difference_of_doubles, entry_of, index_of

wp.set_module_options({"enable_backward": False, "fast_math": False})


@wp.kernel
def gather_energy(
    first: int, mass: wp.array[float], precise_velocity: wp.array[wp.vec3d], energy_sum: wp.array[wp.float64]
):
    """Add the kinetic energy of this step to ``energy_sum`` (n,) [J]."""
    i = wp.tid() + first
    u = precise_velocity[i]
    energy_sum[i] += wp.float64(0.5) * wp.float64(mass[i]) * wp.dot(u, u)


@wp.kernel
def find_means(
    first: int,
    interval: wp.float64,
    steps: wp.array[int],
    neighbours: NeighbourList,
    precise_position: wp.array[wp.vec3d],
    energy_sum: wp.array[wp.float64],
    place_before: wp.array[wp.vec3d],
    mean_velocity: wp.array[wp.vec3],
    mean_energy: wp.array[float],
):
    """Find the mean velocity (n,) [m/s] over ``interval`` [s] and the mean kinetic energy (n,) [J] of all steps."""
    i = wp.tid() + first
    x = precise_position[i]
    if interval > wp.float64(0.0):
        u = difference_of_doubles(neighbours, x, place_before[i]) / interval  # Greenspan (4.2), of places
        mean_velocity[i] = wp.vec3(float(u[0]), float(u[1]), float(u[2]))
        mean_energy[i] = float(energy_sum[i] / wp.float64(steps[0]))  # Greenspan, section 5
    place_before[i] = x


@wp.func
def is_calm(
    i: int,
    highest_speed: float,
    highest_energy: float,
    mean_velocity: wp.array[wp.vec3],
    mean_energy: wp.array[float],
) -> bool:
    """Whether a particle is slow and cool enough to be bonded."""
    return wp.length(mean_velocity[i]) <= highest_speed and mean_energy[i] < highest_energy


@wp.kernel
def find_solids(
    first: int,
    bond_squared: wp.float64,
    highest_speed: float,
    highest_energy: float,
    neighbours: NeighbourList,
    precise_position: wp.array[wp.vec3d],
    mean_velocity: wp.array[wp.vec3],
    mean_energy: wp.array[float],
    phase: wp.array[int],
):
    """Write the phase (n,): solid with two others at which all sides are shorter than a bond, and all three calm."""
    i = wp.tid() + first
    solid = bool(False)
    if is_calm(i, highest_speed, highest_energy, mean_velocity, mean_energy):
        x_i = precise_position[i]
        for k in range(neighbours.count[i]):
            j = index_of(entry_of(neighbours, i, k))
            x_j = precise_position[j]
            if (
                not solid
                and wp.length_sq(difference_of_doubles(neighbours, x_j, x_i)) < bond_squared
                and is_calm(j, highest_speed, highest_energy, mean_velocity, mean_energy)
            ):
                for other in range(k):
                    m = index_of(entry_of(neighbours, i, other))
                    x_m = precise_position[m]
                    if (
                        wp.length_sq(difference_of_doubles(neighbours, x_m, x_i)) < bond_squared
                        and wp.length_sq(difference_of_doubles(neighbours, x_m, x_j)) < bond_squared
                        and is_calm(m, highest_speed, highest_energy, mean_velocity, mean_energy)
                    ):
                        solid = True
    phase[i] = wp.where(solid, int(Phase.SOLID), int(Phase.LIQUID))
