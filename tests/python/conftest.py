"""A small scene and one run of it, shared by all tests."""
import pytest

import diefill

QUICK = {"powder.grain_diameter": "3 mm", "powder.reduced_modulus": "1 MPa", "walls.sphere_radius": "0.4 mm",
         "measure.snapshot_interval": "0.1 s"}


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
