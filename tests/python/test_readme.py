"""What the README shows, runs."""

import re
import subprocess
import sys

import pytest
from conftest import ROOT
from pages import texts


def test_python(fmus, tmp_path):
    (tmp_path / "feeder.fmu").symlink_to(fmus["feeder"].resolve())
    # The other block is tests/python/test_wheel.py's.
    (block,) = (block for block in texts("README.md", "python") if "simulate_fmu(\n" in block)
    done = subprocess.run([sys.executable, "-c", block], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert done.returncode == 0, done.stderr
    time, force, _, overlap = map(float, re.findall(r"-?[0-9.]+(?:e[-+][0-9]+)?", done.stdout))
    assert time == pytest.approx(1.0) and force <= 0 and overlap <= 1e-6


def test_scenes(command, tmp_path):
    for block in texts("README.md", "toml"):
        scene = tmp_path / "scene.toml"
        scene.write_text(block)
        subprocess.run([command, "check", scene], check=True)
        subprocess.run([command, "run", scene, "-o", tmp_path / "out", "--stop", "0.1", "--overwrite"], check=True)


PAGES = (
    "README.md", "examples/README.md", "examples/two_fmus/README.md", "docs/scene.md", "docs/results.md",
    "docs/fmu.md", "docs/master.md", "docs/coupling.md", "docs/faq.md", "docs/index.md", "docs/python.md",
    *(str(path.relative_to(ROOT)) for pages in ("*tutorial.md", "howto/*.md") for path in sorted(ROOT.glob(f"docs/{pages}"))),
)


def test_commands_exist(command):
    """Every `sphere-dda NAME` on the pages is a subcommand; those of research stand in a line of the help."""
    text = "".join((ROOT / page).read_text(encoding="utf-8") for page in PAGES)
    named = set(re.findall(r"(?:sphere-dda|cargo run --release --) ([a-z]+(?:-[a-z]+)*)\b(?! --release)", text))
    assert {"demo", "run", "export", "check", "simulate", "inspect", "view", "movie"} <= named
    told = subprocess.run([command, "--help"], capture_output=True, text=True, check=True).stdout
    commands = set(re.findall(r"^  ([a-z-]+)  ", told, re.M))
    research = set(re.findall(r"`sphere-dda ([a-z-]+)`", told))
    for name in research:
        subprocess.run([command, name, "--help"], capture_output=True, check=True)
    assert named <= commands | research, f"no commands: {sorted(named - commands - research)}"


def anchors(page):
    """What a link can name behind `#`: the headings as GitHub writes them."""
    text = re.sub(r"^```.*?^```$", "", page.read_text(encoding="utf-8"), flags=re.S | re.M)
    headings = re.findall(r"^#+ (.+)$", text, re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).replace(" ", "-") for heading in headings}


def test_links_lead_somewhere():
    pages = [*PAGES, "CONTRIBUTING.md", "CHANGELOG.md", "docs/accuracy.md", "docs/glossary.md", "docs/theory.md"]
    for page in pages:
        for link, anchor in re.findall(r"\]\(([^)#]*)(?:#([^)]*))?\)", (ROOT / page).read_text(encoding="utf-8")):
            if "://" not in link:
                target = (ROOT / page).parent / link if link else ROOT / page
                assert target.exists(), f"{page}: {link}"
                assert not anchor or target.suffix != ".md" or anchor in anchors(target), f"{page}: {link}#{anchor}"


def test_the_glossary_names_what_exists():
    """Identifiers of docs/glossary.md are words of the solver or of the variable table."""
    sources = [path for folder in ("src", "fmu/src") for path in (ROOT / folder).rglob("*.rs")]
    words = set(re.findall(r"\w+", " ".join(path.read_text(encoding="utf-8") for path in sources)))
    rows = [line.split("|") for line in (ROOT / "docs/glossary.md").read_text(encoding="utf-8").splitlines()]
    rows = [row for row in rows if len(row) == 8]
    assert len(rows) > 50
    named = {word for row in rows for code in re.findall(r"`([^`]*)`", row[4]) for word in re.findall(r"\w+", code)}
    assert named <= words, f"not in the code: {sorted(named - words)}"
