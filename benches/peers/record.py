"""The record of a comparison: the machine and all rows, in the order they ran; the page is made of it alone."""

import json
from dataclasses import asdict, dataclass
from pathlib import Path
from statistics import mean, median

from runs import Failed, Row, from_dict

FILE = "benchmarks/record.jsonl"


@dataclass
class Record:
    """`machine` is what the times depend on."""

    machine: dict[str, str]
    rows: list[Row | Failed]

    def write(self, folder: Path) -> None:
        """Writes it below `folder`, one row a line after the machine."""
        path = folder / FILE
        path.parent.mkdir(parents=True, exist_ok=True)
        lines = [json.dumps(self.machine), *(json.dumps(asdict(row)) for row in self.rows)]
        path.write_text("\n".join(lines) + "\n")

    @staticmethod
    def read(folder: Path) -> "Record":
        """The record that was written below `folder`."""
        first, *others = (folder / FILE).read_text().splitlines()
        return Record(json.loads(first), [from_dict(json.loads(line)) for line in others])

    def add(self, other: "Record", without: set[str]) -> None:
        """Takes over the rows of an earlier record but for those of some groups, and the command they came from."""
        self.machine["command"] = f"{other.machine['command']}; {self.machine['command']}"
        self.rows += [row for row in other.rows if row.group not in without]

    def of(self, *groups: str) -> list[Row]:
        """The rows of these groups that have an outcome."""
        return [row for row in self.rows if isinstance(row, Row) and row.group in groups]

    def failed(self) -> list[Failed]:
        """The rows that have none."""
        return [row for row in self.rows if isinstance(row, Failed)]

    def ratios(self, group: str) -> dict[str, list[float]]:
        """CPU time of each own row over the mean of the reference's rows just before and after it, by `Case.key`."""
        rows = [row for row in self.rows if row.group == group]
        found: dict[str, list[float]] = {}
        for before, row, after in zip(rows, rows[1:], rows[2:], strict=False):
            # A reference stands between two cases, or between two runs of one.
            if not row.case.code.startswith("sphere-dda") or before.case != after.case:
                continue
            if isinstance(before, Row) and isinstance(row, Row) and isinstance(after, Row):
                reference = mean([before.outcome.cpu_s, after.outcome.cpu_s])
                found.setdefault(row.case.key, []).append(row.outcome.cpu_s / reference)
        return found


def merged(rows: list[Row]) -> list[list[Row]]:
    """Rows of the same case together, in the order of their first."""
    found: dict[str, list[Row]] = {}
    for row in rows:
        found.setdefault(row.case.key, []).append(row)
    return list(found.values())


def cpu(rows: list[Row]) -> float:
    """Median CPU time [s] of rows of one case."""
    return median(row.outcome.cpu_s for row in rows)
