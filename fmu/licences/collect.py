"""Collects the licences of all crates that the FMU's library links, on any platform it is built for, from the sources that cargo has.

    python3 fmu/licences/collect.py > fmu/licences/third-party.txt
    python3 fmu/licences/collect.py sphere-dda-cli         those of the command, for wheels

A test compares the names and versions in the file with Cargo.lock.
"""

import json
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PLATFORMS = ("x86_64-unknown-linux-gnu", "x86_64-pc-windows-gnu", "wasm32-unknown-unknown")
NAMES = ("LICENSE", "LICENCE", "COPYING", "NOTICE", "UNLICENSE", "COPYRIGHT")
RULE = "=" * 100


def cargo(*arguments):
    return subprocess.run(["cargo", *arguments], cwd=ROOT, check=True, capture_output=True, text=True).stdout


def linked(ours):
    """(name, version) of all crates of others that our crate links; procedural macros run in the compiler only."""
    found = set()
    for platform in PLATFORMS:
        tree = cargo("tree", "--locked", "-p", ours, "-e", "normal,no-proc-macro", "--prefix", "none",
                     "--target", platform, "--format", "{p}")
        for line in tree.splitlines():
            name, version = line.split()[:2]
            if not name.startswith("sphere-dda"):
                found.add((name, version.removeprefix("v")))
    return sorted(found)


def texts(package):
    """The licence files of a crate; of one that has none, the MIT licence if it is offered under that."""
    folder = Path(package["manifest_path"]).parent
    files = [p for p in sorted(folder.iterdir()) if p.is_file() and p.name.upper().startswith(NAMES)]
    if package["license_file"]:
        files.append(folder / package["license_file"])
    if files:
        return list(dict.fromkeys(f.read_text(errors="replace").strip() for f in files))
    if "MIT" not in (package["license"] or ""):
        sys.exit(f"{package['name']} has no text of its licence `{package['license']}`: add it by hand")
    _, body = (ROOT / "LICENSE-MIT").read_text().split("\nPermission", 1)
    owners = ", ".join(a.split(" <")[0] for a in package["authors"]) or f"the authors of {package['repository']}"
    return [f"MIT License\n\nCopyright (c) {owners}\n\nPermission{body}".strip()]


def main():
    ours = sys.argv[1] if len(sys.argv) > 1 else "sphere-dda-fmu"
    what = "the library of this FMU" if ours == "sphere-dda-fmu" else "the command sphere-dda"
    packages = json.loads(cargo("metadata", "--locked", "--format-version", "1"))["packages"]
    known = {(p["name"], p["version"]): p for p in packages}
    shared = {}
    print(f"Crates that {what} links; made by fmu/licences/collect.py.\n")
    print("The Rust standard library is linked too: MIT OR Apache-2.0, https://github.com/rust-lang/rust.\n")
    bodies = []
    for key in linked(ours):
        package = known[key]
        numbers = []
        for text in texts(package):
            shared.setdefault(text, len(shared) + 1)
            numbers.append(f"[{shared[text]}]")
        authors = ", ".join(package["authors"]) or "the authors of the project"
        where = package["repository"] or f"https://crates.io/crates/{key[0]}"
        print(f"- {key[0]} {key[1]}: {package['license']}; {authors}; {where}; {' '.join(numbers)}")
    for text, number in shared.items():
        bodies.append(f"\n{RULE}\n[{number}]\n\n{text}\n")
    print("".join(bodies), end="")


if __name__ == "__main__":
    sys.exit(main())
