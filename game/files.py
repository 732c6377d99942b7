"""Files of the user: an old one is replaced by a new one, all of it or nothing."""

import os
import tempfile
from pathlib import Path


def write(path: Path, text: str) -> None:
    """Put the text there, so that whoever reads finds the old file or the new one; OSError."""
    number, temporary = tempfile.mkstemp(dir=path.parent, prefix=path.name, suffix=".tmp")
    try:
        with open(number, "w", encoding="utf-8") as file:
            file.write(text)
            file.flush()
            os.fsync(file.fileno())
        os.replace(temporary, path)
    except OSError:
        Path(temporary).unlink(missing_ok=True)
        raise
