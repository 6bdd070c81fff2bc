"""Writes fclib's HDF5 problems, local and global, as text in the format of Siconos: `convert.py FILE... -o DIR`."""

import argparse
import sys
from pathlib import Path

import h5py
import numpy as np


def main() -> int:
    """The command; 2 if a file is no fclib problem."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("files", nargs="+", type=Path)
    parser.add_argument("-o", "--output", type=Path, required=True)
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    for path in arguments.files:
        try:
            text = converted(path)
        except (OSError, KeyError, ValueError) as error:
            print(f"{path}: {error}; expected HDF5 with fclib_local or fclib_global", file=sys.stderr)
            return 2
        (arguments.output / f"{path.stem}.dat").write_text(text)
    return 0


def converted(path: Path) -> str:
    """The text of one problem."""
    with h5py.File(path) as file:
        if "fclib_local" in file:
            problem, matrices, vectors = file["fclib_local"], ["W"], ["q", "mu"]
        elif "fclib_global" in file:
            problem, matrices, vectors = file["fclib_global"], ["M", "H"], ["f", "w", "mu"]
        else:
            raise KeyError(f"found {', '.join(file)}")
        if "G" in problem or "V" in problem:
            raise ValueError("found bilateral rows (G), which no solver here takes")
        contacts = problem["vectors/mu"].size
        lines = [str(int(problem["spacedim"][0])), str(contacts)]
        for name in matrices:
            lines += matrix(problem[name])
        for name in vectors:
            lines.append(" ".join(repr(float(x)) for x in problem["vectors"][name][()]))
    return "\n".join(lines) + "\n"


def matrix(group: h5py.Group) -> list[str]:
    """Triplets under the title that CSparse prints."""
    rows, columns, kind = (int(group[name][0]) for name in ("m", "n", "nz"))
    i, p, x = (group[name][()] for name in ("i", "p", "x"))
    if kind >= 0:  # triplets: p has columns
        row, column = i, p
    elif kind == -1:  # compressed columns
        row, column = i, np.repeat(np.arange(columns), np.diff(p))
    else:  # compressed rows
        row, column = np.repeat(np.arange(rows), np.diff(p)), i
    title = "CSparse converted from fclib"
    entries = [f"    {a} {b} : {v!r}" for a, b, v in zip(row.tolist(), column.tolist(), x.tolist(), strict=True)]
    size = f"triplet: {rows}-by-{columns}, nzmax: {len(entries)} nnz: {len(entries)}"
    return ["2", str(rows), str(columns), "1", title, size, *entries]


if __name__ == "__main__":
    sys.exit(main())
