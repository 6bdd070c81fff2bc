"""Runs a bin with a slot over widths and gravities on a Dask cluster: one FMU, one run per pair, one table, one picture.

    sphere-dda export examples/study/bin.toml -o bin.fmu
    python examples/study/study.py --fmu bin.fmu --workers 2 --output study-output

Beverloo's argument for a slot of width B and length L: the rate W knows neither the height of the bed nor the walls, so that by
dimensions W = C rho sqrt(g) L (B - k d)^(3/2), rho the bulk density, d the grain. Rigid grains have no other time than
sqrt(d / g): a bin on the Moon is the bin on Earth in slow motion, until chaos has made another sample of it. Steps and times
are therefore measured in that time, and the rates of all gravities must fall on one curve.

Rows appear in study.csv as runs end, sorted, and stay: a study that was stopped goes on with what is missing. A run that fails, or whose
process dies, is a row with the reason. Needs distributed, fmpy, numpy and matplotlib.
"""

import argparse
import csv
import itertools
import os
import tempfile
from contextlib import ExitStack
from pathlib import Path

import dask
import fmpy
import numpy as np
from distributed import Client, LocalCluster, as_completed

OPENINGS = [0.04, 0.05, 0.06, 0.07, 0.08]  # [m]
GRAVITIES = [1.62, 3.71, 9.81, 24.8]  # Moon, Mars, Earth, Jupiter [m/s2]
GRAIN, SLOT, SHAPE = 0.01, 0.04, 1.4  # mean diameter d [m], length L of the slot [m], k of spheres
DENSITY = 2500.0  # of a grain [kg/m3]
# On Earth [s]: step of the solver, time between rows, longest time, time without outflow that makes a jam.
EARTH, STEP, ROW, LONGEST, JAM = 9.81, 2.5e-4, 5e-3, 4.0, 0.5
BEGUN, ENDED = 0.08, 0.35  # shares of the mass between which the rate is taken
COLUMNS = ["fmu", "opening", "gravity", "rate", "bulkDensity", "worstOverlap", "error"]
# A process that dies takes others' work with it: those are tried again, and a run that killed three is given up.
DEATHS = 2


def discharge(folder, opening, gravity):
    """Rate [kg/s], bulk density [kg/m3] as the flow begins, worst overlap over radius of a run of the unpacked FMU."""
    slow = np.sqrt(EARTH / gravity)
    said = []
    description = fmpy.read_model_description(folder)
    outputs = ["sensor.outflow.mass", "mass", "sensor.bed.solidFraction", "maxOverlap"]
    order = {v.name: k for k, v in enumerate(v for v in description.modelVariables if v.name in outputs)}
    jam = round(JAM / ROW)

    def flows(time, recorder):
        left, mass = (np.array(recorder.rows)[:, 1 + order[name]] for name in outputs[:2])
        return left[-1] < ENDED * mass[0] and not (len(left) > jam and left[-1] == left[-1 - jam])

    fmu = fmpy.instantiate_fmu(
        folder, description, logger=lambda environment, instance, status, category, text: said.append(text.decode())
    )
    try:
        rows = fmpy.simulate_fmu(
            folder,
            model_description=description,
            fmu_instance=fmu,
            stop_time=LONGEST * slow,
            output_interval=ROW * slow,
            start_values={
                "boundary.left.displacement": opening / 2,
                "boundary.right.displacement": opening / 2,
                "gravity[3]": -gravity,
                "solver.step": STEP * slow,
            },
            output=outputs,
            step_finished=flows,
        )
    except Exception as error:
        # The FMU has told its log why; fmpy only knows that it failed.
        raise RuntimeError("; ".join([*said, str(error)])) from error
    finally:
        fmu.freeInstance()
    left, mass, fraction, overlap = (rows[name] for name in outputs)
    share = left / mass[0]
    if share[-1] < ENDED:
        raise RuntimeError(f"{share[-1]:.1%} have left within {rows['time'][-1]:.2f} s, then it stood; expected {ENDED:.0%}")
    part = (share > BEGUN) & (share <= ENDED)
    rate = np.polyfit(rows["time"][part], left[part], 1)[0]
    return rate, DENSITY * fraction[part][0], overlap.max()


def name(opening, gravity):
    """What a run is found by in the table: digits that read back to the same numbers."""
    return repr(float(opening)), repr(float(gravity))


def read(path, guid):
    """Rows of the table at `path` by opening and gravity; none if there is no such file."""
    if not path.exists():
        return {}
    with path.open(newline="") as file:
        rows = list(csv.DictReader(file))
    for row in rows:
        if row["fmu"] != guid:
            raise SystemExit(f"{path} holds runs of the FMU {row['fmu']}, expected {guid}: name another --output, or remove it")
    return {(row["opening"], row["gravity"]): row for row in rows}


def write(path, rows):
    """Replaces the table as a whole, sorted, so that a study that is killed leaves a complete one."""
    fresh = path.with_suffix(".new")
    with fresh.open("w", newline="") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(rows[key] for key in sorted(rows, key=lambda key: tuple(map(float, key))))
    os.replace(fresh, path)


def study(fmu, output, openings=OPENINGS, gravities=GRAVITIES, workers=2, scheduler=None, retry=False, run=discharge):
    """Rows of the table by opening and gravity; runs what is missing, with `retry` also what has failed."""
    output.mkdir(parents=True, exist_ok=True)
    path = output / "study.csv"
    guid = fmpy.read_model_description(str(fmu)).guid
    rows = read(path, guid)
    pairs = [name(*pair) for pair in itertools.product(openings, gravities)]
    missing = [key for key in pairs if key not in rows or (retry and rows[key]["error"])]
    if not missing:
        return rows
    with ExitStack() as stack:
        # Unpacked once, where workers of other machines see it if they see the output.
        folder = stack.enter_context(tempfile.TemporaryDirectory(prefix="fmu-", dir=output.resolve()))
        fmpy.extract(str(fmu), folder)
        if scheduler is None:
            stack.enter_context(dask.config.set({"distributed.scheduler.allowed-failures": DEATHS}))
            # One run per process: an FMU that brings its process down takes one run with it.
            scheduler = stack.enter_context(
                LocalCluster(n_workers=workers, threads_per_worker=1, processes=True, dashboard_address=":0")
            )
        client = stack.enter_context(Client(scheduler))
        # Not pure: a run that failed is not to be remembered by the scheduler.
        futures = {client.submit(run, folder, *map(float, key), pure=False): key for key in missing}
        for k, future in enumerate(as_completed(futures), 1):
            key = futures[future]
            row = dict.fromkeys(COLUMNS, "") | {"fmu": guid, "opening": key[0], "gravity": key[1]}
            if (error := future.exception()) is None:
                row |= zip(("rate", "bulkDensity", "worstOverlap"), (f"{value:.6g}" for value in future.result()))
            else:
                row["error"] = " ".join(f"{type(error).__name__}: {error}".split())
            rows[key] = row
            write(path, rows)
            print(f"{k} of {len(futures)}: opening {key[0]} m, gravity {key[1]} m/s2: {row['error'] or row['rate'] + ' kg/s'}", flush=True)
    return rows


def columns(rows):
    """Arrays of opening, gravity, rate, bulk density and worst overlap of the runs that went well, sorted by opening and gravity."""
    good = [[float(row[column]) for column in COLUMNS[1:-1]] for row in rows.values() if not row["error"]]
    return np.array(sorted(good)).reshape(-1, len(COLUMNS) - 2).T


def slope(x, y):
    """Of the line through ln y over ln x, with its standard error; no numbers where nothing can be fitted."""
    if len(set(x)) < 2 or len(x) < 3:
        return np.nan, np.nan
    line, covariance = np.polyfit(np.log(x), np.log(y), 1, cov=True)
    return line[0], np.sqrt(covariance[0, 0])


def judge(rows):
    """Exponents of B - k d and of g, each with its standard error; C for 3/2 and 1/2, by run."""
    opening, gravity, rate, density, _ = columns(rows)
    if len(opening) == 0:
        raise SystemExit("no run went well: see the column `error`")
    width = opening - SHAPE * GRAIN
    of_width = slope(width, rate / np.sqrt(gravity))
    of_gravity = slope(gravity, rate / width**1.5)
    return of_width, of_gravity, rate / (density * np.sqrt(gravity) * SLOT * width**1.5)


def plot(rows, path):
    """Rates as measured, and over sqrt(g) with the line of exponent 3/2."""
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    opening, gravity, rate, density, _ = columns(rows)
    *_, constant = judge(rows)
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4), layout="constrained")
    for g in sorted(set(gravity)):
        of = gravity == g
        width = opening[of] - SHAPE * GRAIN
        left.plot(opening[of] * 1e3, rate[of], "o-", label=f"{g} m/s2")
        right.loglog(width / GRAIN, rate[of] / np.sqrt(g), "o", label=f"{g} m/s2")
    width = np.linspace(opening.min(), opening.max()) - SHAPE * GRAIN
    line = np.median(constant) * np.median(density) * SLOT * width**1.5
    right.loglog(width / GRAIN, line, "k-", lw=1, label=f"C = {np.median(constant):.2f}, exponent 3/2")
    left.set_xlabel("slot [mm]")
    left.set_ylabel("rate [kg/s]")
    right.set_xlabel("(B - 1.4 d) / d")
    right.set_ylabel("rate / sqrt(g) [kg / sqrt(m)]")
    for axes in (left, right):
        axes.grid(alpha=0.3, which="both")
        axes.legend(fontsize="small")
    figure.savefig(path, dpi=110)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--fmu", type=Path, default=Path("bin.fmu"))
    parser.add_argument("--output", type=Path, default=Path("study-output"))
    parser.add_argument("--workers", type=int, default=2, help="processes on this machine")
    parser.add_argument("--scheduler", help="address of a running Dask scheduler instead, whose workers see --output")
    parser.add_argument("--openings", type=float, nargs="+", default=OPENINGS, metavar="B", help="widths of the slot [m]")
    parser.add_argument("--gravities", type=float, nargs="+", default=GRAVITIES, metavar="G", help="[m/s2]")
    parser.add_argument("--retry", action="store_true", help="run again what has failed")
    a = parser.parse_args()
    rows = study(a.fmu, a.output, a.openings, a.gravities, a.workers, a.scheduler, a.retry)
    plot(rows, a.output / "study.png")
    of_width, of_gravity, constant = judge(rows)
    print(f"{len(constant)} of {len(rows)} runs went well")
    print(f"exponent of B - {SHAPE} d: {of_width[0]:.3f} +- {of_width[1]:.3f}, expected 1.5")
    print(f"exponent of g: {of_gravity[0]:.3f} +- {of_gravity[1]:.3f}, expected 0.5")
    print(f"C = {constant.mean():.3f}, from {constant.min():.3f} to {constant.max():.3f}")


if __name__ == "__main__":
    main()
