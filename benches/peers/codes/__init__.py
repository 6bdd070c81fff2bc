"""The codes that are compared: each has `run(case, scene, folder)`, which gives an `Outcome`."""
