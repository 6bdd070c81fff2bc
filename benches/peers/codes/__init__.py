"""The codes that are compared.

Each has `run(case, scene, folder)`, which gives an `Outcome`, and `CANNOT`, the scenes that it does not run, and why.
"""

import importlib
from types import ModuleType

MODULES = {
    "sphere-dda": "sphere_dda",
    "sphere-dda-fmi": "sphere_dda_fmi",
    "rapier": "rapier",
    "liggghts": "liggghts",
    "mujoco": "mujoco_peer",
    "newton": "newton_peer",
}


def module(code: str) -> ModuleType:
    """The adapter of a code; the code itself need not be installed to ask it for `CANNOT`."""
    return importlib.import_module(f"codes.{MODULES[code]}")


def missing(scene: str) -> dict[str, str]:
    """Why codes do not run a scene, by code."""
    reasons = {code: module(code).CANNOT.get(scene) for code in MODULES}
    return {code: why for code, why in reasons.items() if why is not None}
