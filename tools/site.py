"""What `mkdocs build` does beyond its plugins: runs the gallery, and takes in files outside docs/.

Pages link to files as they lie in the repository. Notebooks become pages, and so does every file
that a page links to and that is no page: its text, to read.
"""

import posixpath
import re
import sys
from functools import cache
from pathlib import Path
from typing import Any

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT))  # mkdocs loads this file by its path

from mkdocs.structure.files import File, Files  # noqa: E402

from tools import notebook  # noqa: E402

LINK = re.compile(r"(?<=\]\()([^)\s:#]+)(?=[)#])")
INDEX = re.compile(  # of a letter, but not in code, links and indented lines
    r"(?ms)(^```.*?^```|`[^`]*`|\]\([^)]*\)|^    .*?$)"
    r"|(?<![\w/])([A-Za-zα-ω])_([a-zθφ]{1,2}|\d)(?!\w)"
)
ROW = re.compile(r"(?m)^\| \[([^]]*)\]\((\w+)\.md\) \|")
PICTURES = (".png", ".webp", ".svg", ".gif")
OWN = "docs/"
ELSEWHERE = {"CHANGELOG.md": "changelog.md", "CONTRIBUTING.md": "contributing.md"}
ICON = "assets/icon-64.png"
GALLERY = "docs/gallery/"
UNSOUGHT = "---\nsearch:\n  exclude: true\nhide: [navigation]\n---\n\n"


def home(path: str) -> str:
    """Where a file of the repository is in the site."""
    if path.startswith(OWN) and not path.endswith(".py"):
        return path.removeprefix(OWN)
    if path.startswith(GALLERY):
        return path.removeprefix(OWN).removesuffix(".py") + ".md"
    if path in ELSEWHERE:
        return ELSEWHERE[path]
    if (ROOT / path).is_dir():
        return f"source/{path}/index.md"
    return f"source/{path}" + ("" if path.endswith((".md", *PICTURES)) else ".md")


def targets(text: str, path: str) -> list[str]:
    """The files of the repository to which the text of one links."""
    found = [posixpath.normpath(posixpath.join(path, "..", link)) for link in LINK.findall(text)]
    return [target for target in found if (ROOT / target).exists()]


def relinked(text: str, path: str) -> str:
    """With links as they are in the site."""

    def link(match: re.Match[str]) -> str:
        target = posixpath.normpath(posixpath.join(path, "..", match[0]))
        if not (ROOT / target).exists():
            return match[0]
        return posixpath.relpath(home(target), posixpath.dirname(home(path)) or ".")

    return LINK.sub(link, text)


def as_page(path: str) -> str:
    """A file from outside docs/ as a page; a folder as the list of the pages in it."""
    if (ROOT / path).is_dir():
        names = sorted(file.name for file in (ROOT / path).glob("*.md"))
        return f"{UNSOUGHT}# {path}\n\n" + "".join(f"- [{name}]({name})\n" for name in names)
    text = (ROOT / path).read_text(encoding="utf-8")
    if path.endswith(".md"):
        return ("" if path in ELSEWHERE else UNSOUGHT) + relinked(text, path)
    kind = Path(path).suffix.removeprefix(".")
    return f"{UNSOUGHT}# {path}\n\n````{kind}\n{text}````\n"


def on_config(config: Any) -> Any:
    """Entries whose pages are not written yet are left out; a page without an entry is an error."""
    config.nav = [*filter(None, map(_there, config.nav))]
    return config


def _there(entry: Any) -> Any:
    if isinstance(entry, str):
        files = [OWN + entry, *_made_from(entry)]
        return entry if any((ROOT / file).exists() for file in files) else None
    ((title, under),) = entry.items()
    under = [*filter(None, map(_there, under))] if isinstance(under, list) else _there(under)
    return {title: under} if under else None


def _made_from(entry: str) -> list[str]:
    """The files outside docs/, or the script, of which a page is made."""
    outside = [path for path, page in ELSEWHERE.items() if page == entry]
    return [*outside, OWN + entry.removesuffix(".md") + ".py"]


def on_files(files: Files, config: Any) -> Files:
    """Add the gallery's pages, and all that pages link to."""
    made = {ICON: (ROOT / ICON).read_bytes()}
    notebooks = sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / GALLERY).glob("*.py"))
    for path in notebooks:
        made |= _notebook(path, (ROOT / path).read_text(encoding="utf-8"))
    waiting = [OWN + file.src_uri for file in files.documentation_pages()] + notebooks
    waiting += [path for path in ELSEWHERE if (ROOT / path).exists()]
    for path in waiting:  # grows
        if home(path).startswith("source/") or path in ELSEWHERE:
            picture = path.endswith(PICTURES)
            made[home(path)] = (ROOT / path).read_bytes() if picture else as_page(path)
        waiting += [new for new in _outside(path) if new not in waiting]
    for name, content in made.items():
        files.append(File.generated(config, name, content=content))
    return files


def _outside(path: str) -> dict[str, None]:
    """What a page links to that is no page or picture of docs/."""
    if (ROOT / path).is_dir():
        return dict.fromkeys(p.relative_to(ROOT).as_posix() for p in (ROOT / path).glob("*.md"))
    if not path.endswith(".md") and not path.startswith(GALLERY):
        return {}
    found = targets((ROOT / path).read_text(encoding="utf-8"), path)
    return dict.fromkeys(p for p in found if home(p).startswith("source/"))


@cache  # for `mkdocs serve`, which builds again after each edit of any page
def _notebook(path: str, script: str) -> dict[str, Any]:
    """The files of the site that are made of a script: its page, its pictures, its .ipynb."""
    page = home(path).removesuffix(".md")
    done = [*notebook.run(script)]
    text, pictures = notebook.page(done, posixpath.basename(page))
    text = relinked(text, path)
    text += f"\n[As a notebook, to download]({posixpath.basename(page)}.ipynb){{ .md-button }}\n"
    made = {f"gallery/{name}": picture for name, picture in pictures.items()}
    return {f"{page}.md": text, f"{page}.ipynb": notebook.ipynb(done), **made}


def on_page_markdown(markdown: str, page: Any, config: Any, files: Files) -> str:
    """Links to where things are in the site; indices set low; sessions coloured as such."""
    if not page.file.generated_by:
        markdown = relinked(markdown, OWN + page.file.src_uri)
    if page.file.src_uri == "index.md":
        page.meta["hide"] = ["navigation", "toc"]
    if page.file.src_uri == "gallery/index.md":
        markdown = ROW.sub(r"| [![](\2-1.png){ width=230 }](\2.md) | **[\1](\2.md)**<br>", markdown)
    if page.file.src_uri == "physics.md":
        markdown = INDEX.sub(lambda found: found[1] or f"{found[2]}<sub>{found[3]}</sub>", markdown)
    return re.sub(r"(?m)^```python\n(?=>>>)", "```pycon\n", markdown)


def on_post_page(output: str, page: Any, config: Any) -> str:
    """Screen readers and search engines are told which pages are Korean."""
    korean = page.file.src_uri.startswith("ko/")
    return output.replace('<html lang="en"', '<html lang="ko"', 1) if korean else output
