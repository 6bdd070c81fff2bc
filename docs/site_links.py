"""Hook of mkdocs: a link that leaves docs/ becomes one to the repository, and must lead to a file."""

import logging
import posixpath
import re
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
LINK = re.compile(r"(!?)(\[[^\]]*\]\()(\.\./[^)#\s]*)")
log = logging.getLogger("mkdocs.hooks.site_links")


def on_page_markdown(markdown, page, config, files):
    repository = config.extra["repository"]
    folder = posixpath.dirname(f"docs/{page.file.src_uri}")

    def outward(match):
        image, text, link = match.groups()
        target = posixpath.normpath(posixpath.join(folder, link))
        if target.startswith("docs/"):
            return match[0]
        path = ROOT / target
        if not path.exists():
            log.warning("%s: the link %s leads to no file", page.file.src_uri, link)
        kind = "raw" if image else "tree" if path.is_dir() else "blob"
        return f"{image}{text}{repository}/{kind}/main/{target}"

    return LINK.sub(outward, markdown)
