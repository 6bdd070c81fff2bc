"""Pages of `view`: one HTML file that works offline; notebooks show it inline."""

from __future__ import annotations

import html
import os
import webbrowser
from pathlib import Path

from . import command


class Page:
    """An HTML page of a scene or a run. The last line of a notebook cell shows it."""

    def __init__(self, path: Path, height: int = 600, keep: object = None):
        #: The file.
        self.path = path
        #: Height of the frame in a notebook [px].
        self.height = height
        # A page in a temporary folder lives as long as that.
        self._keep = keep

    @classmethod
    def of(
        cls, source: str | os.PathLike[str], output: str | os.PathLike[str], keep: object = None, **options: object
    ) -> Page:
        """Has the command write the page of a scene or a result folder; `max_size="10MB"` is its `--max-size`."""
        path = Path(output).absolute()
        flags = [text for key, value in options.items() for text in (f"--{key.replace('_', '-')}", str(value))]
        command.run("view", source, "-o", path, "--overwrite", *flags)
        return cls(path, keep=keep)

    def open(self) -> None:
        """Starts the browser."""
        webbrowser.open(self.path.as_uri())

    def _repr_html_(self) -> str:
        text = html.escape(self.path.read_text(encoding="utf-8"))
        return f'<iframe srcdoc="{text}" width="100%" height="{self.height}" style="border:0"></iframe>'

    def __repr__(self) -> str:
        return f"Page({str(self.path)!r})"
