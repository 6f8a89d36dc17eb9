"""One step of the simulation, term by term."""

from collections.abc import Sequence

import numpy as np
import warp as wp

from warpsph.core.constants import (
    colour_field_constants,
    contact_constants,
    elastic_constants,
    fluid_constants,
    surface_constants,
    thermal_table,
)
from warpsph.core.executor import Executor
from warpsph.core.labels import Phase
from warpsph.core.model import Model
from warpsph.core.neighbours import Neighbours
from warpsph.core.state import State
from warpsph.core.term import BoundaryDevice
from warpsph.kernels.basics import motion
from warpsph.kernels.basics.smoothing import normalisation
from warpsph.kernels.flow import colour_field_tension, continuity, density, forces, surface_tension, wall_pressure
from warpsph.kernels.heat import conduction, phase
from warpsph.kernels.neighbours import lists as neighbours
from warpsph.kernels.solid import bonds, contact, elasticity


class Solver:
    """Advances the state; knows no file, no picture and no schedule.

    A step moves the flow by ``dt``; every ``heat_every`` steps a step with heat conducts for all of them at once.

    Args:
        executor: launches.
        model: what stays the same.
        state: what changes.
        devices: boundary devices, in the order in which they act.
        dt: time step [s].
        heat_every: steps between two conduction steps.
        lower, upper: box of the neighbour grid [m].
        speed_limit: speed that no particle can have unless the simulation has diverged [m/s].
        skin: of the neighbour list, in spacings.
    """

    def __init__(
        self,
        executor: Executor,
        model: Model,
        state: State,
        devices: Sequence[BoundaryDevice],
        dt: float,
        heat_every: int,
        lower: np.ndarray,
        upper: np.ndarray,
        speed_limit: float,
        skin: float = 0.4,
    ):
        self.executor, self.model, self.state, self.devices = executor, model, state, list(devices)
        self.dt, self.heat_every, self.speed_limit = dt, heat_every, speed_limit
        self.time = wp.zeros(1, dtype=wp.float64, device=executor.device)
        self.steps = wp.zeros(1, dtype=int, device=executor.device)
        self.runaway = wp.zeros(1, dtype=int, device=executor.device)
        starts_solid = bool(model.elasticity) and np.any(state.numpy("phase") == Phase.SOLID)
        self.phase_changed = wp.array([int(starts_solid)], dtype=int, device=executor.device)
        self.bond_events = wp.zeros(1, dtype=int, device=executor.device)
        self.longest_bond_row = wp.zeros(1, dtype=int, device=executor.device)
        has_contact = model.elasticity is not None and model.elasticity.contact
        self.contact = contact_constants(model) if has_contact else None
        self.neighbours = Neighbours(
            executor,
            state,
            max(model.support, self.contact.reach) if has_contact else model.support,
            skin * model.spacing,
            lower,
            upper,
            model.dimension,
            len(model.materials),
            model.spacing,
        )
        self.fluid = fluid_constants(model) if model.fluid else None
        if model.surface_tension:
            published = model.surface_tension.published
            self.surface = colour_field_constants(model) if published else surface_constants(model)
        self.elastic = elastic_constants(model) if model.elasticity else None
        if model.conduction:
            self.thermal_table = thermal_table(model, executor.device)
            self.conduction_scale = normalisation("poly6", model.dimension, model.support) / model.lattice_conduction()
        for device in self.devices:
            device.bind(self)

    def prepare(self) -> None:
        """Bring what follows from the initial state up to date: neighbours, temperature, density, bonds, stress."""
        if self.model.conduction:
            self._find_temperature()
        self.neighbours.renew_if_outdated()
        if self.model.fluid:
            self._find_density(0.0)
            self._extrapolate_pressure()
        if self.model.elasticity:
            self.executor.when(self.phase_changed, self._bond_solids)
        if self.model.phase_change:
            self._change_phase()
        if self.model.elasticity:
            self._find_stress()

    def step(self) -> None:
        """Advance the flow by one time step."""
        section = self.executor.section
        self.neighbours.renew_if_outdated()
        if self.model.fluid:
            with section():
                self._find_density(self.dt)
                for device in self.devices:
                    device.after_density(self.dt)
            self._extrapolate_pressure()
        with section():
            motion.advance_clock(self.executor, self.dt, self.time, self.steps)
            if self.model.surface_tension and not self.model.surface_tension.published:
                self._find_surface_normal()
            if self.model.fluid:
                self._find_forces()
            elif self.model.elasticity:
                motion.fall(self.executor, wp.vec3(*self.model.gravity), self.state.acceleration)
            if self.model.elasticity:
                self._find_stress()
        with section():
            if self.model.surface_tension:
                self._add_surface_tension()
            if self.model.elasticity:
                self._add_elastic_forces()
                if self.contact:
                    self._add_contact_forces()
            if self.model.fluid or self.model.elasticity:
                self._kick()
        with section():
            self._drift()
            for device in self.devices:
                device.after_move(self.dt)
            self._watch()

    def step_with_heat(self) -> None:
        """Advance the flow by one time step, and heat by as many as have passed since the last conduction."""
        self.step()
        self.neighbours.renew_if_outdated()
        interval = self.heat_every * self.dt
        self._conduct(interval)
        for device in self.devices:
            device.after_heat(interval)
        self._find_temperature()
        if self.model.phase_change:
            self._change_phase()

    def _find_density(self, interval: float) -> None:
        s = self.state
        if self.model.fluid.continuity:
            continuity.advance_density(
                self.executor,
                self.fluid,
                interval,
                self.neighbours.list,
                s.position,
                s.velocity,
                s.fluid_mass,
                s.role,
                s.density,
                s.density_carry,
                s.pressure,
                s.volume,
            )
            return
        density.sum_density(
            self.executor,
            self.fluid,
            self.neighbours.list,
            s.position,
            s.fluid_mass,
            s.role,
            s.density,
            s.pressure,
            s.volume,
        )

    def _extrapolate_pressure(self) -> None:
        s = self.state
        wall_pressure.extrapolate_pressure(
            self.executor, self.fluid, self.neighbours.list, s.position, s.density, s.role, s.pressure
        )

    def _find_forces(self) -> None:
        s = self.state
        forces.sum_forces(
            self.executor,
            self.fluid,
            self.neighbours.list,
            s.position,
            s.velocity,
            s.density,
            s.pressure,
            s.volume,
            s.viscosity,
            s.role,
            s.acceleration,
        )

    def _find_surface_normal(self) -> None:
        s = self.state
        surface_tension.find_surface_normal(
            self.executor,
            self.surface,
            self.neighbours.list,
            s.position,
            s.fluid_mass,
            s.role,
            s.phase,
            s.surface_normal,
        )

    def _add_surface_tension(self) -> None:
        s = self.state
        if self.model.surface_tension.published:
            add, given = colour_field_tension.add_colour_field_tension, (s.density, s.volume, s.role, s.phase)
        else:
            add, given = surface_tension.add_surface_tension, (s.fluid_mass, s.surface_normal)
        add(self.executor, self.surface, self.neighbours.list, s.position, *given, s.acceleration)

    def _find_stress(self) -> None:
        s = self.state
        elasticity.find_stress(
            self.executor, self.elastic, s.bonds, s.position, s.body_volume, s.correction, s.deformation, s.stress
        )

    def _add_elastic_forces(self) -> None:
        s = self.state
        elasticity.add_elastic_forces(
            self.executor,
            self.elastic,
            s.bonds,
            s.position,
            s.role,
            s.mass,
            s.body_volume,
            s.deformation,
            s.stress,
            s.acceleration,
        )

    def _add_contact_forces(self) -> None:
        s = self.state
        contact.add_contact_forces(
            self.executor,
            self.contact,
            self.neighbours.list,
            s.position,
            s.role,
            s.body,
            s.mass,
            s.acceleration,
        )

    def _kick(self) -> None:
        motion.kick(self.executor, self.dt, self.state.role, self.state.acceleration, self.state.velocity)

    def _drift(self) -> None:
        s = self.state
        motion.drift(self.executor, self.dt, s.role, s.velocity, s.position, s.position_carry)

    def _watch(self) -> None:
        s, n = self.state, self.neighbours
        motion.watch(
            self.executor,
            s.role,
            s.position,
            s.velocity,
            n.reference,
            n.half_skin,
            self.speed_limit,
            n.outdated,
            self.runaway,
        )

    def _conduct(self, interval: float) -> None:
        s = self.state
        conduction.sum_heat(
            self.executor,
            self.thermal_table,
            self.neighbours.list,
            self.model.support,
            self.conduction_scale,
            s.position,
            s.role,
            s.temperature,
            s.conductivity,
            s.thermal_volume,
            s.material,
            s.heat_rate,
        )
        conduction.add_heat(
            self.executor, interval, s.role, s.heat_rate, s.mass, s.held, s.enthalpy, s.enthalpy_carry, s.heat_held
        )

    def _find_temperature(self) -> None:
        s = self.state
        conduction.update_temperature(
            self.executor, self.thermal_table, s.material, s.enthalpy, s.temperature, s.solid_fraction, s.conductivity
        )

    def _change_phase(self) -> None:
        s, rule = self.state, self.model.phase_change
        phase.switch_phase(
            self.executor,
            rule.freeze_above,
            rule.melt_below,
            s.role,
            s.solid_fraction,
            s.phase,
            s.froze,
            self.phase_changed,
        )
        if self.model.elasticity:
            self.executor.when(self.phase_changed, self._renew_bonds)

    def _renew_bonds(self) -> None:
        s = self.state
        if self.model.fluid:
            elasticity.settle_volume(self.executor, s.froze, s.mass, s.density, s.body_volume)
        self._bond_solids()

    def _bond_solids(self) -> None:
        s, n = self.state, self.neighbours
        bonds.update_bonds(
            self.executor,
            self.model.support,
            normalisation("sine", self.model.dimension, self.model.support),
            n.list,
            s.position,
            s.phase,
            s.froze,
            s.bonds,
            self.longest_bond_row,
        )
        elasticity.invert_moments(self.executor, self.elastic, s.bonds, s.body_volume, s.correction)
        bonds.mark_bonded_neighbours(self.executor, n.list, s.bonds)
        neighbours.clear_flag(self.executor, self.phase_changed, self.bond_events)
