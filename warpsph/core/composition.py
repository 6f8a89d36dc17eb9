"""Putting terms together: what excludes each other, what is missing, and in which order they act."""

from dataclasses import fields, is_dataclass, replace

from warpsph.core.dynamics import Dynamics
from warpsph.core.model import Model
from warpsph.core.motion import Motion
from warpsph.core.term import Term
from warpsph.core.verlet import Verlet
from warpsph.errors import InputError


def compose(model: Model, parts: tuple[Term, ...] = ()) -> Model:
    """The model with the parts of a machine among its terms, each after those that it follows.

    Motion is added where no term provides one, dynamics where a term needs forces, and both as one where a term needs
    them of second order.

    Raises:
        InputError: terms exclude each other, one lacks what it needs, or stands where the box is periodic.
    """
    terms: list[Term] = []
    for term in (*model.terms, *parts):
        if not isinstance(term, Term):
            raise InputError(f"terms: {term!r} is not a term; give instances such as {_name(Motion)}()")
        for relation in ("provides", "needs", "follows"):
            if isinstance(getattr(term, relation), str):
                raise InputError(f"{_name(term)}.{relation} is a text; give a tuple of texts, with a comma at its end")
        terms.append(term)
    for built_in, purpose in ((Verlet(), "second-order motion"), (Dynamics(), "forces"), (Motion(), "motion")):
        wanted = purpose == "motion" or any(purpose in term.needs for term in terms)
        if wanted and not any(set(built_in.provides) & set(term.provides) for term in terms):
            terms.insert(0, built_in)
    _refuse_rivals(terms)
    provided = {what for term in terms for what in term.provides}
    for term in terms:
        for what in term.needs:
            if what not in provided:
                raise InputError(f"{_name(term)} needs {what} in the same case: {_remedy(what, term)}")
        _refuse_missing_partners(term, terms)
        _refuse_periodic(term, model)
    return replace(model, terms=tuple(_ordered(terms)))


def _refuse_rivals(terms: list[Term]) -> None:
    for place, term in enumerate(terms):
        if any(other is term for other in terms[:place]):
            raise InputError(f"terms: the same {_name(term)} stands there twice")
        for other in terms[:place]:
            for what in set(term.provides) & set(other.provides):
                raise InputError(f"{_name(other)} and {_name(term)} exclude each other: both provide {what}; drop one")


def _refuse_missing_partners(term: Term, terms: list[Term]) -> None:
    """A part that works with another one needs it in the same case."""
    names: list[str] = [parameter.name for parameter in fields(term)] if is_dataclass(term) else []
    for name in names:
        partner = getattr(term, name)
        if isinstance(partner, Term) and not any(partner is other for other in terms):
            raise InputError(f"{_name(term)}: its {name}, a {_name(partner)}, is missing in the case; add it")


def _refuse_periodic(term: Term, model: Model) -> None:
    """What has one place in space along an axis would have to be there once more in each period."""
    for axis in model.periodic.axes if model.periodic else ():
        if axis in term.bounded_axes(model):
            raise InputError(
                f"{_name(term)} has one place along {'xyz'[axis]}, so the box cannot be periodic there; give "
                f"PeriodicBox a length of 0 along {'xyz'[axis]}, or drop the {_name(term)}"
            )


def _ordered(terms: list[Term]) -> list[Term]:
    """The terms so that each comes after what it follows, otherwise as they were given."""
    left, done = list(terms), []
    while left:
        place = next((k for k, term in enumerate(left) if not any(_waits_for(term, other) for other in left)), None)
        if place is None:
            raise InputError(f"terms wait for each other: {', '.join(map(_name, left))}")
        done.append(left.pop(place))
    return done


def _waits_for(term: Term, other: Term) -> bool:
    """Whether a term acts after another one: it follows it, or needs it without being needed by it."""
    needed = set(term.needs) & set(other.provides) and not set(other.needs) & set(term.provides)
    return term is not other and bool(needed or set(term.follows) & set(other.provides))


def _remedy(what: str, term: Term) -> str:
    """Who could be added: what provides it without excluding the term that needs it."""
    kinds = [kind for kind in _kinds(Term) if what in kind.provides and not set(kind.provides) & set(term.provides)]
    providers = sorted(kind.__name__ for kind in kinds)
    return f"add {' or '.join(providers)}" if providers else "nothing known provides it"


def _kinds(kind: type[Term]) -> set[type[Term]]:
    return {kind, *(further for sub in kind.__subclasses__() for further in _kinds(sub))}


def _name(term: Term | type[Term]) -> str:
    return (term if isinstance(term, type) else type(term)).__name__
