"""A viscous liquid sloshes in a basin: a case of one's own, from a file of particles to a plot."""

from warpsph.core.executor import Executor
from warpsph.core.labels import Role
from warpsph.core.materials import fluid_material, solid_material
from warpsph.core.model import Model
from warpsph.core.particles import Particles, tank
from warpsph.files.particles import read_particles
from warpsph.run.simulation import Simulation
from warpsph.terms import ContinuityDensity, Fluid

SPACING = 0.02  # m

materials = (fluid_material("syrup", 1000.0, viscosity=20.0), solid_material("wall", 1000.0))
model = Model(2, SPACING, materials, terms=(Fluid(1000.0, sound_speed=30.0), ContinuityDensity()))
particles = Particles()
particles.add_table(read_particles("basin.csv", dimension=2), Role.FREE, material="syrup")
particles.add(tank((0.0, 0.0), (0.4, 0.3), SPACING), Role.DUMMY, "wall")
simulation = Simulation(Executor("cpu"), model, particles)

simulation.prepare()  # neighbours, density, walls and forces of the start, without a step
simulation.solver.act("find_density")  # one moment alone, after something was changed by hand
start = simulation.snapshot()  # NumPy arrays, a row a particle
print(f"highest acceleration at the start: {abs(start['acceleration']).max():.3g} m/s^2")

result = simulation.run(duration=1.0, output_interval=0.01, output="basin.vtkhdf", overwrite=True)
energy = result.to_xarray()["kinetic_energy"]  # with time, label and unit
print(f"half of the energy is gone after {energy.time[energy < 0.5 * energy[0]][0].item():.2f} s")
energy.plot()[0].figure.savefig("energy.png")
print(result.to_pandas()[["highest_speed", "density_max"]].describe())
