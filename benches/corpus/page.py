"""The page docs/corpus.md, from the record alone."""

from collections.abc import Iterable
from pathlib import Path
from statistics import median
from typing import Any

NAMES = {
    "NSGS": "NSGS",
    "ADMM": "ADMM",
    "NSN_AC": "Newton (NSN_AC)",
    "NSGS2D": "NSGS in 2D",
    "auto": "auto",
    "gauss-seidel": "gauss-seidel",
    "direct": "direct",
    "newton": "newton",
}
INFINITE = float("inf")

TEXT = """# Judged on others' problems

The contact problems of Siconos' test tree (`numerics/src/FrictionContact/test/data` of its public
repository, Apache-2.0), solved by this project's laws and solvers on general 3x3 blocks and by
Siconos {siconos} (`python3-siconos` of Debian) in the same run:

```sh
benches/corpus/run
```

writes this page and `docs/corpus/record.json`. The error is Siconos' own, taken by Siconos'
`fc3d_compute_error` of everybody's impulses: natural map of the cone with De Saxce's velocity over
the largest norm of `q`, impulses and velocities. All start from zero impulses and stop at 1e-8.
Problems with bodies are reduced to `W = H^T M^-1 H` first, those in two dimensions get a second
tangent that nothing moves; both sides get the same file. Siconos' solver of two dimensions also
gets the original. Time is that of the solve alone, on one thread, the shortest of up to 20
repetitions within 0.05 s: CPU time of Siconos, wall time of this project. Siconos' options are its
defaults but for tolerance and most iterations: 100 000, Newton 1000; a process may take {limit}.

Measured on {processor}; {busy} cores were busy with other work at the start.

## All problems

{summary}

`median time` is over all problems, where an unsolved one takes infinitely long. `best of theirs` is the
fastest of Siconos' solvers that solves the problem, problem by problem. Over the {both} problems that
both `auto` and one of theirs solve, `auto` takes {ratio} of the time of the best of theirs in the median,
and is the faster one on {faster}.

{verdict}

## Problem by problem

Time in ms with iterations in brackets: sweeps+factorizations of this project. Where the tolerance
was missed, the error.

{table}

{refused}"""


def write(path: Path, machine: dict[str, str], problems: list[Any], refused: list[str]) -> None:
    """Writes the page."""
    pairs = [(one.ours["auto"].seconds, best(one)) for one in problems if one.ours["auto"].solved and best(one) < INFINITE]
    text = TEXT.format(
        **machine,
        summary=_summary(problems),
        both=len(pairs),
        ratio=f"{median(ours / theirs for ours, theirs in pairs):.2g}",
        faster=sum(ours < theirs for ours, theirs in pairs),
        verdict=_verdict(problems),
        table=_table(problems),
        refused=_refused(refused),
    )
    path.write_text(text)


def best(problem: Any) -> float:
    """Time of the fastest of their solvers that solves it [s]."""
    return min((solve.seconds for solve in problem.theirs.values() if solve.solved), default=INFINITE)


def _solvers(problems: list[Any]) -> list[tuple[str, str]]:
    sides = [("theirs", name) for name in ("NSGS", "ADMM", "NSN_AC", "NSGS2D")]
    sides += [("ours", name) for name in ("auto", "gauss-seidel", "direct", "newton")]
    return [(side, name) for side, name in sides if any(name in getattr(one, side) for one in problems)]


def _rows(lines: Iterable[list[str]]) -> str:
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _summary(problems: list[Any]) -> str:
    lines = [["solver", "of", "problems", "solved", "share", "median time (ms)"], ["---", "---", "---:", "---:", "---:", "---:"]]
    for side, name in _solvers(problems):
        solves = [getattr(one, side)[name] for one in problems if name in getattr(one, side)]
        lines.append([NAMES[name], "Siconos" if side == "theirs" else "sphere-dda", *_figures(solves)])
    times = [best(one) for one in problems]
    done = sum(time < INFINITE for time in times)
    lines.append(["best of theirs", "Siconos", *_figure(done, times)])
    return _rows(lines)


def _figures(solves: list[Any]) -> list[str]:
    times = [solve.seconds if solve.solved else INFINITE for solve in solves]
    return _figure(sum(solve.solved for solve in solves), times)


def _figure(done: int, times: list[float]) -> list[str]:
    return [str(len(times)), str(done), f"{100 * done / len(times):.1f} %", _ms(median(times))]


def _ms(seconds: float) -> str:
    return "-" if seconds == INFINITE else f"{1e3 * seconds:.3g}"


def _verdict(problems: list[Any]) -> str:
    nobody = [one.name for one in problems if not one.ours["auto"].solved]
    alone = [one.name for one in problems if one.ours["auto"].solved and best(one) == INFINITE]
    sentences = []
    if nobody:
        sentences.append(f"Not solved by `auto`: {', '.join(nobody)}.")
    if alone:
        sentences.append(f"Solved by `auto` and none of Siconos' three here: {', '.join(alone)}.")
    slower = [one for one in problems if one.ours["auto"].solved and best(one) < one.ours["auto"].seconds]
    if slower:
        named = ", ".join(f"{one.name} ({_ms(one.ours['auto'].seconds)} against {_ms(best(one))} ms)" for one in slower)
        sentences.append(f"Slower than the best of theirs: {named}.")
    return "\n".join(sentences)


def _cell(solve: Any) -> str:
    if solve is None:
        return ""
    if solve.failed:
        return solve.failed
    if not solve.solved:
        return f"error {solve.error:.0e} ({solve.iterations})"
    return f"{_ms(solve.seconds)} ({solve.iterations})"


def _table(problems: list[Any]) -> str:
    solvers = _solvers(problems)
    lines = [["problem", "contacts", *(NAMES[name] for _, name in solvers)], ["---", "---:", *("---" for _ in solvers)]]
    for one in problems:
        cells = [_cell(getattr(one, side).get(name)) for side, name in solvers]
        lines.append([one.name, str(one.contacts), *cells])
    return _rows(lines)


def _refused(refused: list[str]) -> str:
    if not refused:
        return ""
    return "Files that are no problems:\n\n" + "\n".join(f"- `{line}" for line in refused) + "\n"


def told(problem: Any) -> str:
    """A line of progress."""
    auto = problem.ours["auto"]
    return f"{problem.name:42} {problem.contacts:5}  auto {_cell(auto):>24}  best of theirs {_ms(best(problem))} ms"
