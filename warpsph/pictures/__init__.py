"""Pictures of results; the drawing libraries are loaded only when one of these names is used."""

from importlib import import_module
from typing import Any

_HOMES = {
    "render_still": "still",
    "render_series": "still",
    "render_movie": "movie",
    "plot_diagnostics": "diagnostics_plot",
}
__all__ = list(_HOMES)


def __getattr__(name: str) -> Any:
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)
