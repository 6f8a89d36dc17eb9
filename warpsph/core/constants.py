"""The constants of a model in the form that the kernels take."""

import numpy as np
import warp as wp

from warpsph.core.model import Model
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow import colour_field_tension, density, surface_tension
from warpsph.kernels.heat import conduction
from warpsph.kernels.solid import contact, elasticity

# In spacings. Where the pressure of the melt is zero particles may freeze almost on top of each other; a stiffness of
# the hourglass control that grows as the inverse square of such a length would be unstable at any time step.
SHORTEST_BOND = 0.65

# In spacings. Rows of particles that feel only the particle that faces them would stand on each other like marbles, and
# roll off; at this reach the push along the surface is five to thirty times smaller.
CONTACT_REACH = 2.6


def fluid_constants(model: Model) -> density.Fluid:
    """Constants of the flow: smoothing kernels normalised so that their sums are exact on the lattice."""
    constants = density.Fluid()
    constants.support = model.support
    constants.density_scale = normalisation("poly6", model.dimension, model.support)
    constants.reference_density = model.fluid.reference_density
    constants.stiffness = model.fluid.sound_speed**2 * model.fluid.reference_density / 7.0
    constants.lowest_pressure = -1.0e30 if model.fluid.tension else 0.0
    constants.pressure_scale = normalisation("spiky", model.dimension, model.support) / model.lattice_gradient()
    constants.viscosity_scale = normalisation("viscosity", model.dimension, model.support) / model.lattice_viscosity()
    constants.gravity = wp.vec3(*model.gravity)
    return constants


def surface_constants(model: Model) -> surface_tension.Surface:
    """Constants of the surface tension, with which the force on a unit of surface is exact on the lattice."""
    constants = surface_tension.Surface()
    rho_0 = model.fluid.reference_density
    constants.support = model.support
    constants.scale = normalisation("poly6", model.dimension, model.support) / rho_0
    constants.threshold = model.surface_tension.threshold / model.support
    chi, constants.depth = model.lattice_surface(constants.threshold)
    constants.strength = (model.dimension - 1) * model.surface_tension.coefficient / (chi * rho_0)
    return constants


def colour_field_constants(model: Model) -> colour_field_tension.ColourField:
    """Constants of the published form of surface tension."""
    constants = colour_field_tension.ColourField()
    constants.support = model.support
    constants.scale = normalisation("poly6", model.dimension, model.support)
    constants.dimension = model.dimension
    constants.tension = model.surface_tension.coefficient
    constants.threshold = model.surface_tension.threshold / model.support
    return constants


def elastic_constants(model: Model) -> elasticity.Elastic:
    """Constants of the elastic solid."""
    constants = elasticity.Elastic()
    constants.lame_lambda, constants.lame_mu = model.elasticity.lame
    constants.youngs_modulus = model.elasticity.youngs_modulus
    constants.hourglass = model.elasticity.hourglass
    constants.shortest_squared = (SHORTEST_BOND * model.spacing) ** 2
    constants.corrected = int(model.elasticity.corrected)
    constants.planar = int(model.dimension == 2)
    return constants


def contact_constants(model: Model) -> contact.Contact:
    """Constants of the contact of bodies: two particles a spacing apart are as stiff as the solid between them."""
    lame_lambda, lame_mu = model.elasticity.lame
    constants = contact.Contact()
    constants.reach = CONTACT_REACH * model.spacing
    slope = 4.0 * (1.0 - 1.0 / CONTACT_REACH) ** 3 / CONTACT_REACH
    constants.strength = (lame_lambda + 2.0 * lame_mu) * model.spacing ** (model.dimension - 1) / slope
    return constants


def thermal_table(model: Model, device: wp.Device) -> conduction.ThermalTable:
    """Enthalpy curves, melting ranges and conductivities of all materials, and of their contacts, on the device."""
    nodes = max(len(m.temperatures) for m in model.materials)
    temperature, enthalpy = (np.zeros((len(model.materials), nodes)) for _ in range(2))
    for index, material in enumerate(model.materials):
        highest = material.temperatures[-1] + np.arange(1, nodes - len(material.temperatures) + 1)
        temperature[index] = np.concatenate([material.temperatures, highest])
        enthalpy[index] = material.enthalpy(temperature[index])
    contact = np.full((len(model.materials),) * 2, -1.0)
    for (a, b), conductivity in model.conduction.contact.items():
        contact[a, b] = contact[b, a] = conductivity
    table = conduction.ThermalTable()
    table.temperature = wp.array(temperature, dtype=float, device=device)
    table.enthalpy = wp.array(enthalpy, dtype=float, device=device)
    table.contact = wp.array(contact, dtype=float, device=device)
    for name in ("solidus", "liquidus", "conductivity_solid", "conductivity_liquid"):
        setattr(table, name, wp.array([getattr(m, name) for m in model.materials], dtype=float, device=device))
    return table
