"""Nothing is left behind: loads, lives and unloads of the library, counted to the byte, also under valgrind where it is there."""

import os
import shutil
import subprocess
from pathlib import Path

import fmpy
import pytest
from conftest import ROOT


# Chunks that a thread keeps for reuse would count as used.
ENVIRONMENT = {**os.environ, "GLIBC_TUNABLES": "glibc.malloc.tcache_count=0"}


@pytest.fixture(scope="module", params=["feeder", "drum"])
def cycle(request, fmus, tmp_path_factory):
    """Runs tests/leaks/cycle.c with a feeder, which has a source, or a drum, which is a driven body: cycles, threads, instances per thread."""
    folder = tmp_path_factory.mktemp("leaks")
    program = folder / "cycle"
    subprocess.run(["cc", "-O1", "-Wall", "-Werror", "-o", program, ROOT / "tests/leaks/cycle.c", "-ldl", "-pthread"], check=True)
    description = fmpy.read_model_description(str(fmus[request.param]))
    unpacked = Path(fmpy.extract(str(fmus[request.param]), unzipdir=str(folder / "fmu")))
    library = unpacked / "binaries/linux64" / f"{description.coSimulation.modelIdentifier}.so"

    def run(cycles, threads, instances, *before):
        arguments = [library, description.guid, (unpacked / "resources").as_uri(), cycles, threads, instances]
        done = subprocess.run([*before, program, *map(str, arguments)], capture_output=True, text=True, timeout=1200, env=ENVIRONMENT)
        assert done.returncode == 0, done.stderr
        return *map(int, done.stdout.split()), done.stderr

    return run


@pytest.mark.parametrize(("cycles", "threads", "instances"), [(1000, 0, 1), (40, 8, 8)])
def test_lives_leave_no_byte_and_no_thread(cycle, cycles, threads, instances):
    """Fewer bytes than half the lives that lie between: less than one each. The C library keeps some 32 for threads that meet."""
    early, late, left, _ = cycle(cycles, threads, instances)
    assert left == 1
    assert late - early < cycles * max(threads, 1) * instances / 2, (early, late)


@pytest.mark.skipif(shutil.which("valgrind") is None, reason="valgrind is not installed")
def test_valgrind_finds_no_lost_byte(cycle):
    *_, told = cycle(3, 0, 1, "valgrind", "--leak-check=full", "--errors-for-leak-kinds=definite,indirect,possible", "--error-exitcode=3", f"--suppressions={ROOT / 'tests/leaks/valgrind.supp'}")
    assert "ERROR SUMMARY: 0 errors" in told, told
