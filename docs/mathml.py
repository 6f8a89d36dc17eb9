"""A hook of mkdocs: formulas become MathML when the manual is built, so that no page needs a script for them."""

import html
import re
from typing import Any

from latex2mathml.converter import convert

INLINE = re.compile(r'<span class="arithmatex">\\\((.*?)\\\)</span>', re.DOTALL)
BLOCK = re.compile(r'<div class="arithmatex">\\\[(.*?)\\\]</div>', re.DOTALL)


def mathml(latex: str, display: str) -> str:
    """A formula as MathML.

    Args:
        latex: the formula as it stands in a page.
        display: "inline" or "block".

    Raises:
        ValueError: it holds a command that the converter does not know.
    """
    # the converter sets the letters of \mathrm{...} in italics
    latex = html.unescape(latex).strip().replace(r"\mathrm{", r"\text{")
    found = convert(latex, display=display)
    if unknown := re.search(r"\\[A-Za-z]+", found):
        raise ValueError(f"formula '{latex}': {unknown[0]} is not known to latex2mathml")
    return found


def on_page_content(content: str, **_: Any) -> str:
    """Called by mkdocs for each page."""
    content = BLOCK.sub(lambda formula: mathml(formula[1], "block"), content)
    return INLINE.sub(lambda formula: mathml(formula[1], "inline"), content)
