"""Siconos' measure of given impulses, for the tests: `reference.py FOLDER` prints CSV."""

import os
import sys
from pathlib import Path

import numpy as np
import peer
import siconos.numerics as sn


PLANE = ("FC2D", "FrictionContactProblem")  # names of problems in two dimensions, all dense


def main() -> None:
    """A line for each problem of the folder."""
    # What Siconos prints would stand between the lines.
    out = os.fdopen(os.dup(1), "w")
    os.dup2(2, 1)
    print("problem,at rest,at the probe", file=out)
    for path in sorted(Path(sys.argv[1]).glob("*.dat")):
        if path.name.startswith("GFC3D"):
            whole = sn.globalFrictionContact_new_from_filename(str(path))
            problem = sn.globalFrictionContact_reformulation_FrictionContact(whole)
        else:
            problem = sn.frictionContact_new_from_filename(str(path))
        if problem.dimension == 2:
            problem = lifted(path)
        k = np.arange(problem.numberOfContacts)
        probe = np.stack([1 + k / 10, np.full(k.size, 0.2), -k / 10], axis=1)
        if path.name.startswith(PLANE):
            probe[:, 2] = 0
        errors = [peer.measure(problem, p.ravel()) for p in (np.zeros_like(probe), probe)]
        print(path.stem, *(repr(float(error)) for error in errors), sep=",", file=out, flush=True)


def lifted(path: Path) -> sn.FrictionContactProblem:
    """A dense problem of two dimensions with a second tangent that nothing moves: its measure is fc2d_compute_error's."""
    words = path.read_text().split()
    contacts, size = int(words[1]), int(words[3])
    w = np.array(words[7 : 7 + size**2], float).reshape(size, size, order="F")
    q = np.array(words[7 + size**2 : 7 + size**2 + size], float)
    mu = np.array(words[7 + size**2 + size : 7 + size**2 + size + contacts], float)
    keep = [3 * k + c for k in range(contacts) for c in range(2)]
    whole, free = np.eye(3 * contacts), np.zeros(3 * contacts)
    whole[np.ix_(keep, keep)] = w
    free[keep] = q
    return sn.FrictionContactProblem(3, whole, free, mu)


if __name__ == "__main__":
    main()
