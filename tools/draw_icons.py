"""Draw assets/icon-64.png and assets/icon-256.png with the game's own balls and cloth.

python tools/draw_icons.py
"""

from __future__ import annotations

from pathlib import Path

import pygame

from game.render import theme
from game.render.layout import Layout
from game.render.parts import shapes
from game.render.table import bed, lines
from game.render.table.balls import BallSprites

ASSETS = Path(__file__).parent.parent / "assets"
SIDE = 512
WINDOW = (9000, 5200)
"""A window so large that a ball fills most of an icon."""


def icon() -> pygame.Surface:
    """Return three balls on a rounded square of cloth."""
    layout = Layout(WINDOW, 2.448, 1.270)
    looks = [theme.BALLS[name] for name in ("red 1", "yellow", "white")]
    sprites = BallSprites(layout, looks)
    ground = pygame.Surface((SIDE, SIDE), 0, 32)
    _cloth(ground)
    scale = 0.78 * SIDE / (4 * sprites.px)
    for index, (x, y) in enumerate(((0.50, 0.315), (0.70, 0.66), (0.30, 0.66))):
        _place(ground, sprites, index, (x * SIDE, y * SIDE), scale)
    return _rounded(ground)


def _cloth(ground: pygame.Surface) -> None:
    """Paint cloth that is lit in its middle."""
    blue = theme.CLOTHS["blue"]
    nap = bed.texture(Layout((2560, 1440), 2.448, 1.270), SIDE, SIDE)
    pixels = pygame.surfarray.pixels3d(ground)
    for i in range(SIDE):
        for j in range(SIDE):
            far = ((i / SIDE - 0.5) ** 2 + (j / SIDE - 0.42) ** 2) * 1.3
            light = (1.16 - far) * (1 + float(nap[i, j]))
            pixels[i, j] = [min(255, round(c * light)) for c in blue]


def _place(
    ground: pygame.Surface,
    sprites: BallSprites,
    index: int,
    centre: tuple[float, float],
    scale: float,
) -> None:
    """Draw a shadow and a ball."""
    radius = sprites.px * scale
    for k in range(14):
        lines.dot(
            ground,
            (centre[0], centre[1] + 0.10 * radius),
            radius * (1.30 - 0.022 * k),
            (0, 0, 0),
            0.035,
        )
    ball = sprites.portrait(index)
    size = (round(ball.get_width() * scale), round(ball.get_height() * scale))
    small = pygame.transform.smoothscale(ball, size)
    ground.blit(small, small.get_rect(center=(round(centre[0]), round(centre[1]))))


def _rounded(ground: pygame.Surface) -> pygame.Surface:
    """Cut the corners round."""
    mask = pygame.Surface((SIDE, SIDE), pygame.SRCALPHA, 32)
    shapes.box(mask, mask.get_rect(), SIDE / 64, theme.WHITE, theme.WHITE, radius=14)
    picture = pygame.Surface((SIDE, SIDE), pygame.SRCALPHA, 32)
    picture.blit(ground, (0, 0))
    picture.blit(mask, (0, 0), special_flags=pygame.BLEND_RGBA_MULT)
    return picture


def main() -> None:
    """Write both sizes."""
    large = icon()
    for side in (64, 256):
        small = large
        while small.get_width() > side:
            half = small.get_width() // 2
            small = pygame.transform.smoothscale(small, (half, half))
        pygame.image.save(small, str(ASSETS / f"icon-{side}.png"))


if __name__ == "__main__":
    main()
