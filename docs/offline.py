"""A hook of mkdocs: the build fails where a page would load something from a server elsewhere."""

import re
from typing import Any

LOADED = re.compile(r'<(?:script|link|img|iframe)\b[^>]*\b(?:src|href)="((?:https?:)?//[^"]*)"')


def on_post_page(output: str, page: Any, **_: Any) -> str:
    """Called by mkdocs for each page.

    Raises:
        ValueError: the page loads something from elsewhere.
    """
    if found := LOADED.search(output):
        raise ValueError(f"{page.file.src_uri}: loads {found[1]}; the manual must be readable without a network")
    return output
