"""How well two colours stand out from each other, as WCAG 2.1 measures it."""

from game.render.theme import Colour


def luminance(colour: Colour) -> float:
    """Return the relative luminance of WCAG 2.1, 0 for black and 1 for white."""
    r, g, b = (
        c / 12.92 if c <= 0.04045 else ((c + 0.055) / 1.055) ** 2.4
        for c in (channel / 255 for channel in colour)
    )
    return 0.2126 * r + 0.7152 * g + 0.0722 * b


def contrast(first: Colour, second: Colour) -> float:
    """Return the contrast ratio of WCAG 2.1, 1 to 21."""
    low, high = sorted((luminance(first), luminance(second)))
    return (high + 0.05) / (low + 0.05)
