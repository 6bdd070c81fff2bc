"""Siconos on one local problem: `peer.py FILE SOLVER TOLERANCE` prints a line of JSON. A process of its own, as it may crash."""

import json
import resource
import sys
import time

import numpy as np
import siconos.numerics as sn

# Most iterations: far above what problems need that are solved at all.
MOST = {"NSGS": 100_000, "ADMM": 100_000, "NSN_AC": 1000}
REPEATED = 0.05  # time for which a short solve is repeated, the shortest counts [s]
TIMES = 20
LONGEST = 60  # CPU time of a process [s]


def main() -> None:
    """Solves from rest, and prints error, iterations and the CPU time of the shortest solve."""
    path, name, tolerance = sys.argv[1], sys.argv[2], float(sys.argv[3])
    # Beyond it the process ends by SIGXCPU. The clock of the process is coarse then, that of its one thread is not.
    resource.setrlimit(resource.RLIMIT_CPU, (LONGEST, LONGEST + 1))
    problem = sn.frictionContact_new_from_filename(path)
    plane = problem.dimension == 2
    kind = getattr(sn, f"SICONOS_FRICTION_{problem.dimension}D_{name}")
    drive = sn.fc2d_driver if plane else sn.fc3d_driver
    began, best = time.thread_time(), None
    for _ in range(TIMES):
        options = sn.SolverOptions(kind)
        options.dparam[0], options.iparam[0] = tolerance, MOST[name]
        r, u = np.zeros_like(problem.q), np.zeros_like(problem.q)
        start = time.thread_time()
        drive(problem, r, u, options)
        spent = time.thread_time() - start
        best = spent if best is None else min(best, spent)
        if time.thread_time() - began > REPEATED:
            break
    # Of two dimensions Python has the drivers' word only.
    error = float(options.dparam[1]) if plane else measure(problem, r)
    print(json.dumps({"error": error, "iterations": int(options.iparam[1]), "cpu_s": best}))


def measure(problem: sn.FrictionContactProblem, r: np.ndarray) -> float:
    """Siconos' own measure of impulses, by Siconos."""
    options = sn.SolverOptions(sn.SICONOS_FRICTION_3D_NSGS)
    _, error = sn.fc3d_compute_error(problem, r.copy(), np.zeros_like(r), 1e-8, options, float(np.linalg.norm(problem.q)))
    return float(error)


if __name__ == "__main__":
    main()
