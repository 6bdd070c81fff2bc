"""The FMU as a component of WebAssembly (draft FMI-LS-WASM), in wasmtime, beside the native library."""

import shutil
import subprocess
import time
import zipfile

import fmpy
import numpy as np
import pytest
from conftest import scene

H = 2e-3
STEPS = 100


def export(command, path, name, platforms="wasm", version=3):
    """An FMU of a scene whose sums of products are rounded as a component rounds them."""
    own = shutil.copytree(scene(name).parent, path.parent / "scene", dirs_exist_ok=True) / scene(name).name
    text = own.read_text(encoding="utf-8").replace("[simulation]", '[simulation]\nregisters = "plain"', 1)
    own.write_text(text, encoding="utf-8")
    call = [command, "export", own, "-o", path, "--fmi", str(version), "--platform", platforms]
    return subprocess.run(call, capture_output=True, text=True)


@pytest.fixture(scope="session")
def modules(command, tmp_path_factory):
    """The component and the FMU of a scene, each made once."""
    component = pytest.importorskip("component")
    if not (command.parent / "platforms" / "wasm" / "sphere_dda_fmu.wasm").exists():
        pytest.skip("the module is not there: fmu/platforms/build wasm")
    made = {}

    def get(name):
        if name not in made:
            path = tmp_path_factory.mktemp("wasm") / f"{name}.fmu"
            done = export(command, path, name, "wasm,linux64")
            assert done.returncode == 0, done.stderr
            made[name] = component.Module(path), path
        return made[name]

    return get


def positions(fmu, module):
    return np.array(fmu.get_float64([module.references["spheres.position"]])).reshape(-1, 3)


def native(path):
    from test_fmi3 import Unit

    return Unit(path)


@pytest.mark.parametrize("name", ["drum", "feeder", "gate"])
def test_component_gives_the_bits_of_the_native_library(modules, name):
    module, path = modules(name)
    own = module.instantiate()
    own.start()
    with native(path) as other:
        start = positions(own, module)
        assert np.array_equal(start, other.get("spheres.position"))
        clocks = [0.0, 0.0]
        for k in range(STEPS):
            before = time.perf_counter()
            own.do_step(k * H, H, False)
            middle = time.perf_counter()
            other.step(k * H)
            clocks[0] += middle - before
            clocks[1] += time.perf_counter() - middle
        print(f"{name}: the native library takes {clocks[1] / clocks[0]:.2f} of the component's time")
        assert np.array_equal(positions(own, module), other.get("spheres.position"))
        assert np.abs(positions(own, module) - start).max() > 1e-4 * np.ptp(start, axis=0).max()


def test_states_go_back_to_the_bit_and_to_the_other_library(modules):
    module, path = modules("feeder")
    own = module.instantiate()
    own.start()
    for k in range(5):
        own.do_step(k * H, H, False)
    state, at = own.get_fmu_state(), positions(own, module)
    own.do_step(5 * H, H, False)
    after = positions(own, module)
    own.set_fmu_state(state)
    assert np.array_equal(positions(own, module), at)
    own.do_step(5 * H, H, False)
    assert np.array_equal(positions(own, module), after)
    second = module.instantiate()
    second.set_fmu_state(state)
    second.do_step(5 * H, H, False)
    assert np.array_equal(positions(second, module), after)
    with native(path) as other:
        other.restore(bytes(state))
        assert np.array_equal(other.get("spheres.position"), at)


def test_refusals_say_why(modules):
    import component

    module, _ = modules("feeder")
    with pytest.raises(component.Failed, match="guid"):
        module.instantiate(token="{other}")
    own = module.instantiate()
    with pytest.raises(component.Failed, match="expected"):
        own.do_step(0.0, H, False)
    own.start()
    with pytest.raises(component.Failed, match="4000000000"):
        own.get_float64([4_000_000_000])
    with pytest.raises(component.Failed, match="hasEventMode"):
        own.enter_event_mode()
    own.do_step(0.0, H, False)


def test_importer_is_called_within_a_step_and_may_end_it(modules):
    module, _ = modules("feeder")
    seen = []

    def update(at, *_):
        seen.append(at)
        return len(seen) == 2, at

    own = module.instantiate(update=update, early_return=True)
    own.start()
    done = own.do_step(0.0, 20 * H, False)
    assert vars(done)["early-return"]
    assert len(seen) == 2


def test_fmi_2_has_no_components(command, tmp_path):
    if not (command.parent / "platforms" / "wasm" / "sphere_dda_fmu.wasm").exists():
        pytest.skip("the module is not there: fmu/platforms/build wasm")
    done = export(command, tmp_path / "x.fmu", "feeder", version=2)
    assert done.returncode == 2 or done.returncode == 1
    assert "--fmi 3" in done.stderr
    assert not (tmp_path / "x.fmu").exists()


def test_other_importers_take_the_archive(modules):
    _, path = modules("feeder")
    with zipfile.ZipFile(path) as archive:
        names = archive.namelist()
    assert "extra/org.modelica.fmi-ls-wasm/manifest.xml" in names
    assert "binaries/wasm32-wasip2/feeder.wasm" in names
    found = fmpy.simulate_fmu(str(path), stop_time=0.01, output_interval=H)
    assert len(found) == 6
