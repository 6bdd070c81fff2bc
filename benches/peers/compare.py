"""Runs this project and its peers on the same scenes, one after the other, and writes docs/benchmarks.md; `run` starts it."""

import argparse
import json
import os
import platform
import shlex
import shutil
import signal
import subprocess
import sys
import time
from dataclasses import asdict
from pathlib import Path

import page
import plan
from codes import sphere_dda, sphere_dda_fmi
from record import FILE, Record
from runs import Case, Failed, Outcome, Row

HERE = Path(__file__).resolve().parent
LONGEST = 360.0  # of one run [min]
QUIET = 0.2  # cores busy with other work, above which times are worth little
LISTEN = 3.0  # time over which that is measured [s]


def main() -> int:
    """The command; 1 if a run failed, 2 if something is missing."""
    arguments = _arguments()
    out: Path = arguments.out
    if arguments.page:
        page.write(Record.read(out), out)
        return 0
    groups = plan.chosen(arguments.quick, arguments.only, arguments.up_to, not arguments.pairs)
    if not groups:
        names = ", ".join(group.name for group in plan.groups(arguments.quick))
        print(f"--only {','.join(arguments.only)}: no such rows; there are {names}", file=sys.stderr)
        return 2
    codes = {case.code for group in groups for case in group.sequence()}
    if "liggghts" in codes and not shutil.which("liggghts"):
        print("`liggghts` is not on the PATH: apt-get install liggghts (Debian, Ubuntu)", file=sys.stderr)
        return 2
    os.environ["SPHERE_DDA_PEERS"] = str(sphere_dda.build())
    if "sphere-dda-fmi" in codes:
        os.environ["SPHERE_DDA"] = str(sphere_dda_fmi.build())
    record = Record(_machine(), [])
    if arguments.keep:
        if not (out / FILE).exists():
            print(f"--keep: there is no {out / FILE} yet", file=sys.stderr)
            return 2
        record.add(Record.read(out), without={group.name for group in groups})
    if float(record.machine["busy"]) > QUIET:
        print(f"warning: other work keeps {record.machine['busy']} cores busy: times are worth little", file=sys.stderr)
    total = sum(len(list(group.sequence())) for group in groups)
    done = failed = 0
    for group in groups:
        for case in group.sequence():
            row = _timed(group.name, case, 60.0 * arguments.limit)
            record.rows.append(row)
            record.write(out)
            done, failed = done + 1, failed + isinstance(row, Failed)
            print(f"{done:3}/{total}  {_told(row)}", flush=True)
    page.write(record, out)
    print(f"{out / 'benchmarks.md'} is written; {failed} of {total} runs failed")
    return 1 if failed else 0


def _arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(prog="benches/peers/run", description=__doc__)
    parser.add_argument("--quick", action="store_true", help="what the goals need, once each: minutes instead of an hour")
    parser.add_argument(
        "--only", type=lambda s: s.split(","), default=[], metavar="A,B", help="these rows only, as bed,slope; bed-peers: the other codes on them"
    )
    parser.add_argument("--pairs", action="store_true", help="without the rows that are not timed beside a reference")
    parser.add_argument("--up-to", type=float, default=1e6, metavar="N", help="no scenes of more spheres")
    parser.add_argument("--limit", type=float, default=LONGEST, metavar="MIN", help=f"stop a run that takes longer ({LONGEST:g} minutes)")
    parser.add_argument("--keep", action="store_true", help="keep the rows of the last record that are not run anew")
    parser.add_argument("--out", type=Path, default=sphere_dda.ROOT / "docs", help="folder of the page (docs)")
    parser.add_argument("--page", action="store_true", help="write the page of the last record anew, run nothing")
    return parser.parse_args()


def _timed(group: str, case: Case, limit: float) -> Row | Failed:
    """The row of one run in a process of its own, which has `limit` seconds."""
    command = [sys.executable, str(HERE / "one.py")]
    pipe = subprocess.PIPE
    # A session of its own: what the run has started ends with it.
    with subprocess.Popen(command, stdin=pipe, stdout=pipe, stderr=pipe, text=True, start_new_session=True) as run:
        try:
            out, errors = run.communicate(json.dumps(asdict(case)), timeout=limit)
        except subprocess.TimeoutExpired:
            os.killpg(run.pid, signal.SIGKILL)
            return Failed(case, group, f"not done after {limit / 60:g} min")
        except BaseException:
            os.killpg(run.pid, signal.SIGKILL)
            raise
    if run.returncode != 0:
        reason = (errors.strip().splitlines() or [f"exit status {run.returncode}"])[-1]
        return Failed(case, group, reason)
    # Codes may print before the last line.
    return Row(case, group, Outcome.from_dict(json.loads(out.splitlines()[-1])))


def _told(row: Row | Failed) -> str:
    case = row.case
    head = f"{row.group:12} {case.code:10} {case.scene:6} {case.n:7} x{case.threads} {case.label:36}"
    if isinstance(row, Failed):
        return f"{head} failed: {row.error}"
    outcome = row.outcome
    worst = "not watched" if outcome.largest is None else f"{outcome.largest:.1e}"
    return f"{head} {outcome.cpu_s:8.2f} s  worst {worst}  end {outcome.end.overlap:.1e}"


def _busy() -> float:
    """Number of cores that other work keeps busy."""
    before, begun = _idle(), time.perf_counter()
    time.sleep(LISTEN)
    idle = (_idle() - before) / (time.perf_counter() - begun)
    return max(0.0, (os.cpu_count() or 1) - idle)


def _idle() -> float:
    """Time all cores together have been idle or waiting for disks [s]."""
    fields = Path("/proc/stat").read_text().splitlines()[0].split()
    return (int(fields[4]) + int(fields[5])) / os.sysconf("SC_CLK_TCK")


def _machine() -> dict[str, str]:
    """What a reader needs to judge the times by."""
    info = Path("/proc/cpuinfo").read_text().splitlines()
    models = [line.split(":")[1].strip() for line in info if line.startswith("model name")]
    speeds = [float(line.split(":")[1]) for line in info if line.startswith("cpu MHz")]
    caches = [line.split(":")[1].strip() for line in info if line.startswith("cache size")]
    commit = ["git", "-C", str(HERE), "describe", "--always", "--dirty"]
    rustc = subprocess.run(["rustc", "--version"], capture_output=True, text=True, check=True).stdout.strip()
    return {
        "date": time.strftime("%Y-%m-%d"),
        "command": shlex.join(["benches/peers/run", *sys.argv[1:]]),
        "processor": models[0] if models else platform.processor(),
        "speed": f"{speeds[0] / 1000:.2f} GHz" if speeds else "unknown",
        "cache": caches[0] if caches else "unknown",
        "cores": str(os.cpu_count()),
        "memory": f"{os.sysconf('SC_PAGE_SIZE') * os.sysconf('SC_PHYS_PAGES') / 2**30:.1f} GiB",
        "system": f"{platform.system()} {platform.release()}",
        "busy": f"{_busy():.1f}",
        "commit": subprocess.run(commit, capture_output=True, text=True, check=False).stdout.strip() or "unknown",
        "rustc": rustc,
    }


if __name__ == "__main__":
    sys.exit(main())
