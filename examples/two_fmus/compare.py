"""How far couplings are from the solution in one solver, over the communication step, and what they cost.

    python examples/two_fmus/compare.py --command sphere-dda --shaker shaker.fmu --output two_fmus-output

The reference has the shaker inside the scene: a driven body on a slide, with its spring and damper, solved together
with the block on it; the shaking of its foot comes as a load, k A sin 2 pi f t, in steps of the solver. Once the steps of the contact solver are short, so that the coupling alone
shows; once they are the communication steps, which is what is cheapest. Writes compare.csv and compare.png. Needs numpy and matplotlib.
"""

import argparse
import re
import subprocess
import time
from pathlib import Path

import numpy as np

FOLDER = Path(__file__).parent
MASS, STIFFNESS, DAMPING = 2.0, 8000.0, 20.0  # the shaker [kg, N/m, N.s/m]
AMPLITUDE, FREQUENCY = 5e-4, 5.0  # its foot [m, Hz]
BLOCK, GRAVITY = 1.0, 9.81  # on it [kg, m/s2]
FINE, REFERENCE, STOP = 1e-5, 2e-6, 0.5  # short steps of the solver, those of the reference, duration [s]
STEPS = [1e-4, 2e-4, 5e-4, 1e-3, 2e-3, 5e-3, 1e-2]
FORCE = "bed.boundary.tray.averageForce[3]=shaker.force"
DISPLACEMENT = "shaker.position=bed.boundary.tray.displacement"
SPEED = "shaker.velocity=bed.boundary.tray.speed"
POSE = ["shaker.position=bed.boundary.tray.translation[3]", "shaker.velocity=bed.boundary.tray.velocity[3]"]
# Name -> input of the tray, coupling, connections.
SCHEMES = {
    "jacobi": ("slide", "jacobi", [DISPLACEMENT]),
    "gauss-seidel": ("slide", "gauss-seidel", [DISPLACEMENT]),
    "jacobi, extrapolated": ("motion", "jacobi", POSE),
    "iterated": ("slide", "iterated", [DISPLACEMENT]),
    "iterated, speed": ("speed", "iterated", [SPEED]),
}
INPUTS = {"slide": "{ slide = [0.0, 0.0, 1.0] }", "speed": "{ slide_speed = [0.0, 0.0, 1.0] }", "motion": '"motion"', "load": '"load"'}
BODY = (
    f"body = {{ mass = {MASS}, joint = {{ slide = [0.0, 0.0, 1.0] }}, spring = {{ stiffness = {STIFFNESS} }}, "
    f"damping = {DAMPING}, gravity = false }}\n"
)


def run(*arguments):
    """What a command says on standard error; its failure is ours."""
    done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(done.stderr)
    return done.stderr


def export(command, folder, kind, step=FINE):
    """The block on the tray as an FMU, the tray with this input; as a body of the scene if that is a load."""
    text = (FOLDER / "plate.toml").read_text()
    replaced = {
        "density = 3819.718634205488": f"density = {3819.718634205488 * BLOCK / MASS!r}",
        "step = 1e-3": f"step = {step}",
        "input = { slide = [0.0, 0.0, 1.0] }\n": f"input = {INPUTS[kind]}\n" + (BODY if kind == "load" else ""),
    }
    for old, new in replaced.items():
        assert old in text, old
        text = text.replace(old, new)
    scene, fmu = folder / f"{kind}.toml", folder / kind / "bed.fmu"
    fmu.parent.mkdir(exist_ok=True)
    scene.write_text(text)
    fmu.unlink(missing_ok=True)
    run(command, "export", scene, "-o", fmu)
    return fmu


def table(path):
    return np.genfromtxt(path, delimiter=",", names=True, deletechars="")


def together(command, folder, step):
    """Times and positions of the tray as a body of the scene."""
    fmu = export(command, folder, "load", step)
    starts = np.arange(round(STOP / step)) * step
    # The load is held over a step: that of its middle.
    loads = STIFFNESS * AMPLITUDE * np.sin(2 * np.pi * FREQUENCY * (starts + step / 2))
    drive = folder / "load.csv"
    header = "time,boundary.tray.appliedForce"
    np.savetxt(drive, np.column_stack([starts, loads]), delimiter=",", header=header, comments="", fmt="%.17g")
    out = folder / "together.csv"
    position = "boundary.tray.position[3]"
    options = ["--record", position, "--step", step, "--stop", STOP, "-o", out, "--overwrite"]
    run(command, "simulate", fmu, "--input", drive, *options)
    rows = table(out)
    return rows["time"], rows[position]


def coupled(command, folder, shaker, fmu, scheme, step, inner):
    """Times and positions of the tray, iterations per step, and seconds; `inner` is the step of the solver."""
    _, coupling, connections = SCHEMES[scheme]
    out = folder / "coupled.csv"
    connect = [part for pair in (*connections, FORCE) for part in ("--connect", pair)]
    values = {"shaker.amplitude": AMPLITUDE, "shaker.frequency": FREQUENCY, "bed.solver.step": inner}
    settings = [f"--set={name}={value}" for name, value in values.items()]
    record = ["--record", "shaker.position", "-o", out, "--overwrite"]
    options = ["--coupling", coupling, "--step", step, "--stop", STOP]
    begun = time.perf_counter()
    said = run(command, "simulate", shaker, fmu, *connect, *settings, *record, *options)
    seconds = time.perf_counter() - begun
    tries = re.search(r"([\d.]+) iterations per step on average", said)
    rows = table(out)
    return rows["time"], rows["shaker.position"], float(tries[1]) if tries else 1.0, seconds


def exact(t):
    """(m + m_g) x'' + d x' + k x = k A sin 2 pi f t - m_g g from rest at 0, while the block stays on the tray."""
    mass, omega = MASS + BLOCK, 2 * np.pi * FREQUENCY
    steady = STIFFNESS * AMPLITUDE / complex(STIFFNESS - mass * omega**2, DAMPING * omega)
    decay = DAMPING / (2 * mass)
    free = np.sqrt(STIFFNESS / mass - decay**2)
    sag = -BLOCK * GRAVITY / STIFFNESS
    a = -sag - steady.imag
    b = (decay * a - omega * steady.real) / free
    shaken = (steady * np.exp(1j * omega * t)).imag
    return sag + shaken + np.exp(-decay * t) * (a * np.cos(free * t) + b * np.sin(free * t))


def error(times, found, reference):
    """Root mean square of the difference, over that of the reference."""
    known = np.interp(times, *reference)
    return float(np.sqrt(np.mean((found - known) ** 2) / np.mean(reference[1] ** 2)))


def compare(command, shaker, folder, steps=STEPS, reference_step=REFERENCE):
    """Rows (scheme, step, step of the solver, error, tries, seconds), and the error of the reference itself against the
    closed form."""
    reference = together(command, folder, reference_step)
    own = error(*reference, (reference[0], exact(reference[0])))
    beds = {kind: export(command, folder, kind) for kind in ("slide", "speed", "motion")}
    rows = []
    for scheme, (kind, *_) in SCHEMES.items():
        for step in steps:
            for inner in (FINE, step):
                times, found, *cost = coupled(command, folder, shaker, beds[kind], scheme, step, inner)
                rows.append((scheme, step, inner, error(times, found, reference), *cost))
    return rows, own


def plot(rows, own, path):
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 4.6), sharey=True, layout="constrained")
    for scheme, marker in zip(SCHEMES, "osv^D"):
        for axes, cheap in ((left, False), (right, True)):
            mine = [row for row in rows if row[0] == scheme and (row[1] == row[2]) == cheap]
            steps, inner, errors, tries = (np.array([row[k] for row in mine]) for k in (1, 2, 3, 4))
            axes.loglog(tries * STOP / inner if cheap else steps, errors, marker=marker, label=scheme)
    for axes in (left, right):
        axes.axhline(own, color="grey", linestyle=":", label="the reference against the closed form")
        axes.grid(True, which="both", alpha=0.3)
    left.set_title(f"solver in steps of {FINE:g} s", fontsize=10)
    left.set_xlabel("communication step [s]")
    left.set_ylabel("error of the position, RMS / RMS")
    right.set_title("solver in one step per communication step", fontsize=10)
    right.set_xlabel("steps of the contact solver, tries included")
    figure.legend(*right.get_legend_handles_labels(), fontsize=9, loc="outside lower center", ncol=3)
    figure.savefig(path, dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--command", default="sphere-dda")
    parser.add_argument("--shaker", type=Path, default=Path("shaker.fmu"))
    parser.add_argument("--output", type=Path, default=Path("two_fmus-output"))
    arguments = parser.parse_args()
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows, own = compare(arguments.command, arguments.shaker, arguments.output)
    print(f"the reference against the closed form: {own:.2e}")
    with (arguments.output / "compare.csv").open("w") as file:
        print("coupling,step,solver,error,tries,seconds", file=file)
        for scheme, step, inner, wrong, tries, seconds in rows:
            print(f'"{scheme}",{step},{inner},{wrong:.4e},{tries},{seconds:.2f}', file=file)
            print(f"{scheme:22} {step:8g} s in {inner:8g} s  error {wrong:.2e}  {tries:.2f} tries  {seconds:.2f} s")
    plot(rows, own, arguments.output / "compare.png")


if __name__ == "__main__":
    main()
