"""A small scene and one run of it, shared by all tests."""
import os

import pytest

import diefill

# The damping of the preset would shorten the time step of grains as soft as these.
QUICK = {"powder.grain_diameter": "3 mm", "powder.reduced_modulus": "1 MPa",
         "powder.damping_over_radius": "3e5 Pa s/m", "numerics.time_step_fraction": 0.3,
         "walls.sphere_radius": "0.4 mm", "measure.snapshot_interval": "0.1 s"}


@pytest.fixture(scope="session", autouse=True)
def one_processor():
    """For all programs that the tests start: so few grains keep one thread busy, and on a busy machine several would
    wait for each other."""
    os.sched_setaffinity(0, {max(os.sched_getaffinity(0))})


@pytest.fixture(scope="session")
def scene(tmp_path_factory):
    """A rectangular die with coarse, soft grains."""
    return diefill.new(tmp_path_factory.mktemp("scene") / "die").changed(QUICK)


@pytest.fixture(scope="session")
def folder(scene, tmp_path_factory):
    """Results of the scene."""
    out = tmp_path_factory.mktemp("run") / "out"
    scene.run(out, threads=1)
    return out
