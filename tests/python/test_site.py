"""The site of docs/: every page is in the navigation, every link leads somewhere, no page asks another server."""

import os
import re
import shutil
import subprocess
import sys

import pytest
from conftest import ROOT


def build(project, site):
    """Exit code and messages of `mkdocs build --strict`. With `--quiet` it would not count warnings."""
    done = subprocess.run(
        [sys.executable, "-m", "mkdocs", "build", "--strict", "-f", project / "mkdocs.yml", "-d", site],
        env={**os.environ, "NO_MKDOCS_2_WARNING": "1"}, capture_output=True, text=True, timeout=120,
    )
    return done.returncode, done.stdout + done.stderr


def test_the_site_is_built_without_a_warning(tmp_path):
    code, said = build(ROOT, tmp_path / "site")
    assert code == 0, said
    page = (tmp_path / "site/howto/motor-and-drum/index.html").read_text(encoding="utf-8")
    assert "https://github.com/sphere-dda/sphere-dda/blob/main/examples/drum/turn.py" in page
    for html in (tmp_path / "site").rglob("*.html"):
        loaded = re.findall(r'<(?:script|img)[^>]* src="?(https?:[^" >]*)', html.read_text(encoding="utf-8"))
        loaded = [address for address in loaded if "/sphere-dda/raw/main/" not in address]
        assert not loaded, f"{html}: {loaded}"


@pytest.mark.parametrize(
    ("link", "told"),
    [
        ("[x](nowhere.md)", "nowhere.md"),
        ("[x](fmu.md#no-such-heading)", "no-such-heading"),
        ("[x](../examples/no_such.toml)", "no_such.toml"),
        ("![x](pictures/no_such.png)", "no_such.png"),
    ],
)
def test_a_broken_link_fails(tmp_path, link, told):
    """On a small copy: the settings and the hook of the site, two of its pages."""
    (tmp_path / "docs").mkdir()
    (tmp_path / "examples").symlink_to(ROOT / "examples")
    shutil.copy(ROOT / "docs/site_links.py", tmp_path / "docs")
    settings = (ROOT / "mkdocs.yml").read_text(encoding="utf-8").split("\nnav:")[0]
    (tmp_path / "mkdocs.yml").write_text(settings, encoding="utf-8")
    (tmp_path / "docs/fmu.md").write_text("# Reference\n", encoding="utf-8")
    index = tmp_path / "docs/index.md"
    index.write_text("# Start\n\n[x](fmu.md#reference) [y](../examples/README.md)\n", encoding="utf-8")
    code, said = build(tmp_path, tmp_path / "site")
    assert code == 0, said
    index.write_text(f"# Start\n\n{link}\n", encoding="utf-8")
    code, said = build(tmp_path, tmp_path / "site")
    assert code != 0 and told in said, said
