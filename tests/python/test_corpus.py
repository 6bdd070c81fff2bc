"""The page on others' problems says what the record has: unsolved problems count as infinitely slow. Siconos is not needed."""

import importlib.util
from dataclasses import dataclass

from conftest import ROOT

specification = importlib.util.spec_from_file_location("corpus_page", ROOT / "benches" / "corpus" / "page.py")
page = importlib.util.module_from_spec(specification)
specification.loader.exec_module(page)


@dataclass
class Solve:
    error: float
    seconds: float
    iterations: str = "3"
    failed: str = ""

    @property
    def solved(self):
        return not self.failed and self.error <= 1e-8


@dataclass
class Problem:
    name: str
    ours: dict
    theirs: dict
    contacts: int = 2


PROBLEMS = [
    Problem("a", {"auto": Solve(1e-9, 1e-3)}, {"NSGS": Solve(1e-9, 2e-3), "ADMM": Solve(1e-9, 4e-3)}),
    Problem("b", {"auto": Solve(1e-9, 3e-3)}, {"NSGS": Solve(1e-5, 1e-3), "ADMM": Solve(1e-9, 2e-3)}),
    Problem("c", {"auto": Solve(1e-4, 1e-3)}, {"NSGS": Solve(1.0, 60, failed="more than 60 s"), "ADMM": Solve(1e-6, 1)}),
]


def test_the_best_of_theirs_is_one_that_solves():
    assert [page.best(problem) for problem in PROBLEMS] == [2e-3, 2e-3, float("inf")]


def test_what_is_missed_is_named_and_counts_as_infinitely_slow(tmp_path):
    path = tmp_path / "corpus.md"
    page.write(path, {"processor": "P", "busy": "0.0", "siconos": "4.4", "limit": "60 s"}, PROBLEMS, ["ACinputs.dat`: found it"])
    text = path.read_text()
    rows = {tuple(cell.strip() for cell in line.split("|")[1:3]): line for line in text.splitlines() if line.startswith("| ")}
    assert rows["auto", "sphere-dda"].endswith("| 3 | 2 | 66.7 % | 3 |")
    assert rows["NSGS", "Siconos"].endswith("| 3 | 1 | 33.3 % | - |")
    assert rows["best of theirs", "Siconos"].endswith("| 3 | 2 | 66.7 % | 2 |")
    # In the median of 0.5 and 1.5.
    assert "`auto` takes 1 of the time" in text and "faster one on 1." in text
    assert "Not solved by `auto`: c." in text
    assert "Slower than the best of theirs: b (3 against 2 ms)." in text
    assert "more than 60 s" in rows["c", "2"] and "error 1e-04 (3)" in rows["c", "2"]
    assert "- `ACinputs.dat`: found it" in text
