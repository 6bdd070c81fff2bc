"""Blocks of the pages, and pages that run as they stand."""

import os
import re
import subprocess
import sys
from pathlib import Path

from conftest import ROOT


def blocks(page, *languages):
    """Language and text of the blocks of a page in these languages, in order."""
    text = (ROOT / page).read_text(encoding="utf-8")
    return re.findall(rf"^```({'|'.join(languages)})\n(.*?)^```$", text, re.S | re.M)


def texts(page, language):
    return [text for _, text in blocks(page, language)]


def environment(command):
    """That of somebody with the command and this Python on the path."""
    path = os.pathsep.join([str(command.parent), str(Path(sys.executable).parent), os.environ["PATH"]])
    return {**os.environ, "PATH": path}


def run_page(page, command, folder):
    """Runs all blocks in the folder, beside `examples` and `docs`, and returns what they print.

    A `toml` block is a file: its first line names it.
    """
    for name in ("examples", "docs"):
        (folder / name).symlink_to(ROOT / name)
    said = ""
    for language, block in blocks(page, "sh", "python", "toml"):
        if language == "toml":
            name = re.match(r"# (\w+\.toml)\n", block)
            assert name, f"{page}: a scene begins with `# NAME.toml`:\n{block}"
            (folder / name[1]).write_text(block, encoding="utf-8")
            continue
        runner = ["bash", "-euc", block] if language == "sh" else [sys.executable, "-c", block]
        done = subprocess.run(
            runner, cwd=folder, env=environment(command), capture_output=True, text=True, timeout=300
        )
        assert done.returncode == 0, f"{page}:\n{block}{done.stdout}{done.stderr}"
        said += done.stdout
    return said
