"""Contact of elastic bodies."""

from dataclasses import dataclass

from warpsph.core.launch import Launch
from warpsph.core.model import Model
from warpsph.core.state import State
from warpsph.core.term import Term
from warpsph.kernels.solid.contact import ContactConstants, add_contact_forces
from warpsph.terms.elasticity import Elasticity

# In spacings. Rows of particles that feel only the particle that faces them would stand on each other like marbles, and
# roll off; at this reach the push along the surface is five to thirty times smaller.
CONTACT_REACH = 2.6


@dataclass(frozen=True, eq=False)
class Contact(Term):
    """Different bodies press on each other; not needed with a fluid, whose pressure does so."""

    keeps_momentum = True
    provides = ("contact",)
    needs = ("elasticity",)
    follows = ("elasticity",)

    body = Elasticity.body

    def constants(self, model: Model, state: State) -> dict[str, object]:
        return {"contact": contact_constants(model)}

    def reach(self, model: Model) -> float:
        return CONTACT_REACH * model.spacing

    def add_forces(self, launch: Launch) -> None:
        launch(add_contact_forces)


def contact_constants(model: Model) -> ContactConstants:
    """Two particles a spacing apart are as stiff as the solid between them."""
    lame_lambda, lame_mu = model.the(Elasticity).lame
    constants = ContactConstants()
    constants.reach = CONTACT_REACH * model.spacing
    slope = 4.0 * (1.0 - 1.0 / CONTACT_REACH) ** 3 / CONTACT_REACH
    constants.strength = (lame_lambda + 2.0 * lame_mu) * model.spacing ** (model.dimension - 1) / slope
    return constants
