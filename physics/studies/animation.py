"""What happened as a film: a page that plays it, exact at every moment, or a GIF or MP4 file."""

import json
import os
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from html import escape
from math import ceil
from pathlib import Path
from typing import Any

from physics.checks import positive
from physics.engines.engine import Movable
from physics.kernel.kinds import PHASES
from physics.whole_files import replace

from . import svg
from .plot import MISSING, colours, extent, lay_table

PATIENCE = 1.0  # s: what is done by then needs no bar
WIDE = 8.0  # inches of a film, at DPI dots an inch
DPI = 100
MOST = 20_000  # frames: a film of more would take hours
GONE = {phase.name for phase in PHASES if phase.gone}

Progress = Callable[[int], object]

PLAYER = """<!DOCTYPE html><html><head><meta charset="utf-8"><title>danggu</title><style>
body{font:14px sans-serif;margin:8px;color:#1C222B}p{display:flex;gap:8px;max-width:720px}
input{flex:1}</style></head><body>SVG<p><button>⏸</button><input type="range" min="0" step="any">
<output></output></p><script>
const balls=LEGS,from=FROM,to=TO,rate=RATE,bar=document.querySelector("input"),
discs=document.querySelectorAll("circle"),button=document.querySelector("button");
let now=0,last=null,runs=true;bar.max=to-from;
function show(){balls.forEach((legs,i)=>{let k=0;
while(k+1<legs.length&&legs[k+1][0]<=from+now)k++;
const[t0,x,y,vx,vy,ax,ay]=legs[k],t=Math.max(0,from+now-t0);
discs[i].setAttribute("cx",1000*(x+t*(vx+ax*t/2)));
discs[i].setAttribute("cy",-1000*(y+t*(vy+ay*t/2)));
discs[i].style.display=legs[k][7]?"none":""});
bar.value=now;document.querySelector("output").textContent=(from+now).toFixed(2)+" s"}
function frame(stamp){if(runs){if(last!==null)now+=rate*(stamp-last)/1000;
if(now>to-from){now=to-from;runs=false;button.textContent="▶"}}last=stamp;show();
requestAnimationFrame(frame)}
button.onclick=()=>{if(!runs&&now>=to-from)now=0;runs=!runs;button.textContent=runs?"⏸":"▶"};
bar.oninput=()=>{now=+bar.value};requestAnimationFrame(frame)</script></body></html>
"""


def animate(world: Movable, speed: float = 1.0, rate: float = 30.0) -> "Animation":
    """The whole log as a film; a notebook shows it.

    speed: times as fast as it was.
    rate: frames a second of a GIF or MP4 file; a page draws as many as the screen shows.
    ValueError for what is not above zero, and for a log in which nothing happens.
    """
    world.plan()
    start, end = world.log.start, world.time
    if not world.balls or end <= start:
        raise ValueError("there is nothing to animate: no time has passed in this world's log")
    return Animation(world, positive("animate speed", speed), positive("animate rate", rate))


class Animation:
    """A film of a log. `save` writes it; a notebook shows it as it is."""

    def __init__(self, world: Movable, speed: float, rate: float) -> None:
        self.world, self.speed, self.rate = world, speed, rate

    def __repr__(self) -> str:
        start, end = self.world.log.start, self.world.time
        return f"<Animation of {len(self.world.balls)} balls, {end - start:.4g} s>"

    def html(self) -> str:
        """A page that plays it, by itself: it needs no network and no library."""
        log, names = self.world.log, [ball.name for ball in self.world.balls]
        legs = [
            [
                [round(leg.time, 9), *(round(x, 9) for z in motion for x in (z.real, z.imag)),
                 int(PHASES[leg.phase].gone)]
                for leg in log.legs(name)
                for motion in [(leg.position, leg.velocity, leg.acceleration)]
            ]
            for name in names
        ]  # fmt: skip
        page = PLAYER
        for key, value in (
            ("SVG", svg.frame(self.world, "".join(map(self._disc, names)))),
            ("LEGS", json.dumps(legs)), ("FROM", json.dumps(log.start)),
            ("TO", json.dumps(self.world.time)), ("RATE", json.dumps(self.speed)),
        ):  # fmt: skip
            page = page.replace(key, value, 1)
        return page

    def _disc(self, name: str) -> str:
        body, dark = colours(self.world, name)
        radius = next(ball.radius for ball in self.world.balls if ball.name == name)
        return (
            f'<circle r="{1000.0 * radius:.1f}" fill="{body}" stroke="{dark}" stroke-width="5">'
            f"<title>{escape(name)}</title></circle>"
        )

    def _repr_html_(self) -> str:
        west, east, south, north = extent(self.world)
        height = round(svg.WIDTH * (north - south) / (east - west)) + 70
        page = escape(self.html())
        return f'<iframe srcdoc="{page}" width="{svg.WIDTH + 20}" height="{height}"></iframe>'

    def save(self, path: str | os.PathLike[str], progress: Progress | None = None) -> None:
        """Write it as .html, .gif or .mp4, by the name of the file.

        progress: called with the number of frames done since it was last called; without it, a bar
        is shown on the terminal where tqdm is installed.
        GIF and MP4 need matplotlib (ImportError, saying so), and MP4 the program ffmpeg
        (FileNotFoundError). ValueError for another ending, and for more than 20 000 frames.
        """
        file = Path(path)
        kind = file.suffix.lower()
        if kind == ".html":
            replace(file, self.html().encode())
            return
        if kind not in (".gif", ".mp4"):
            raise ValueError(f"a film is a .html, .gif or .mp4 file, not {file.name!r}")
        self._film(file, kind, progress)

    def times(self) -> Any:
        """(frames,) s of the log."""
        import numpy as np

        start, end = self.world.log.start, self.world.time
        frames = ceil((end - start) * self.rate / self.speed) + 1
        if frames > MOST:
            raise ValueError(f"{frames} frames are too many: at most {MOST}")
        return np.minimum(start + np.arange(frames) * (self.speed / self.rate), end)

    def _film(self, file: Path, kind: str, progress: Progress | None) -> None:
        try:
            from matplotlib.animation import FFMpegWriter, FuncAnimation, PillowWriter
        except ImportError:
            raise ImportError(MISSING) from None
        if kind == ".mp4" and not FFMpegWriter.isAvailable():
            raise FileNotFoundError("MP4 films need the program ffmpeg; .gif and .html do not")
        times = self.times()
        figure, draw = self._figure(times)
        kinds: dict[str, Any] = {".gif": PillowWriter, ".mp4": FFMpegWriter}
        writer = kinds[kind](fps=self.rate)
        film = FuncAnimation(figure, draw, frames=len(times), init_func=lambda: (), blit=False)
        with _bar(len(times), progress) as step:
            film.save(file, writer=writer, dpi=DPI, progress_callback=lambda k, n: step(1))

    def _figure(self, times: Any) -> tuple[Any, Callable[[int], Any]]:
        """The table in a figure, and what moves its balls to where they are in a frame."""
        from matplotlib.figure import Figure
        from matplotlib.patches import Circle

        west, east, south, north = extent(self.world)
        pixels = 2 * round(0.5 * DPI * WIDE * (north - south) / (east - west))  # films want even
        figure = Figure(figsize=(WIDE, pixels / DPI))
        axes = figure.add_axes((0.0, 0.0, 1.0, 1.0))
        axes.set(xlim=(west, east), ylim=(south, north))
        axes.axis("off")
        lay_table(axes, self.world)
        self.world.plan()  # a ball that was just placed is on a leg, too
        motions = [*self.world.log.at(times).values()]
        discs: list[Any] = []
        for ball in self.world.balls:
            body, dark = colours(self.world, ball.name)
            disc = Circle((0.0, 0.0), ball.radius, fc=body, ec=dark, lw=1.4, zorder=7)
            discs.append(axes.add_patch(disc))

        def draw(k: int) -> Any:
            for disc, motion in zip(discs, motions, strict=True):
                disc.center = motion.position[k]
                disc.set_visible(motion.phase[k] not in GONE)
            return discs

        return figure, draw


@contextmanager
def _bar(total: int, progress: Progress | None) -> Iterator[Progress]:
    """What is told of each frame: the caller's own, a bar where tqdm is installed, or nothing."""
    if progress is not None:
        if not callable(progress):
            raise ValueError(f"progress must be callable, not {progress!r}")
        yield progress
        return
    try:
        from tqdm import tqdm
    except ImportError:
        yield lambda frames: None
        return
    with tqdm(total=total, unit=" frames", delay=PATIENCE, disable=None) as shown:
        yield shown.update
