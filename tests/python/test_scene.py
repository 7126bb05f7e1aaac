"""Scenes: changed, estimated, planned, run, stopped and compared."""
import tomllib

import numpy as np
import pytest

import diefill
from diefill.scene import _lines


def test_changes_leave_the_scene_as_it_is(scene):
    slow = scene.changed({"step.1.velocity": "0.1 m/s"})
    assert "step.1.velocity" not in scene.changes
    assert slow.estimate()["shoe"]["speed_m_per_s"] == pytest.approx(0.1)


def test_a_wrong_key_is_bad_input_in_one_line(scene, tmp_path):
    with pytest.raises(diefill.BadInput, match="grain_size") as error:
        scene.changed({"powder.grain_size": "1 mm"}).run(tmp_path / "out")
    assert "\n" not in str(error.value)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("value, plain", [
    (True, True), (3, 3), (0.5, 0.5), ("a \"b\" \\ \x7f\n", "a \"b\" \\ \x7f\n"), (np.bool_(False), False),
    (np.int64(7), 7), (np.float64(1e-5), 1e-5), (np.float32(0.25), 0.25), (np.str_("1 mm"), "1 mm"),
    (np.array([[1, 2], [3, 4]]), [[1, 2], [3, 4]]), (("1 mm", np.int8(2)), ["1 mm", 2]), (range(3), [0, 1, 2]),
    ({"kind": "settle", "a b": {"x": np.float64(2)}}, {"kind": "settle", "a b": {"x": 2}})])
def test_values_of_changes_are_written_as_toml(value, plain):
    written = tomllib.loads("\n".join(_lines({"key": value})))["key"]
    assert written == plain and type(written) is type(plain)


@pytest.mark.parametrize("value", [None, {"1 mm"}, object(), b"1 mm", ["1 mm", None], 1j])
def test_a_value_that_toml_has_no_type_for_is_bad_input(value):
    with pytest.raises(diefill.BadInput, match="seed: .* is of type") as error:
        diefill.Scene("scene.toml", {"seed": value}).estimate()
    assert "\n" not in str(error.value)


def test_numbers_of_numpy_change_a_scene(scene):
    changed = scene.changed({"seed": np.int64(2), "measure.snapshot_interval": "0.2 s"})
    assert changed.estimate()["openings"]


def test_estimate_answers_for_the_cavity(scene):
    opening = scene.estimate()["openings"][0]
    assert opening["critical_speed_one_crossing_m_per_s"] > 0


def test_plan_counts_grains(scene):
    assert scene.plan(pilot=False)["choices"]


def test_new_overwrites_nothing(tmp_path):
    (tmp_path / "mine").write_text("mine")
    with pytest.raises(diefill.BadInput, match="choose another name"):
        diefill.new(tmp_path / "mine")
    assert (tmp_path / "mine").read_text() == "mine"


def test_a_callback_that_raises_stops_with_a_checkpoint(scene, folder, tmp_path):
    heard = []

    def stop(share, doing):
        heard.append(share)
        if share > 0.2:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        scene.run(tmp_path / "out", threads=1, callback=stop)
    assert heard == sorted(heard) and 0.2 < heard[-1] < 1
    assert not (tmp_path / "out" / "results.h5").exists()
    resumed = scene.run(tmp_path / "out", threads=1, resume=True)
    assert resumed.state_hash == diefill.read(folder).state_hash


def test_an_unfinished_run_gives_results_and_a_warning(scene, tmp_path):
    with pytest.warns(diefill.UnfinishedWarning, match="max_time"):
        results = scene.changed({"numerics.max_time": "0.05 s"}).run(tmp_path / "out", threads=1)
    assert len(results.powder) > 0


def test_comparison_judges_variants(scene, tmp_path):
    variants = {"as it is": {}, "fast": {"step.1.velocity": "0.4 m/s"}}
    comparison = scene.compare(variants, tmp_path / "out")
    masses = comparison.measure("filled_mass_kg")
    assert comparison.variants == list(variants) == list(masses)
    assert masses["fast"].verdict == "scatter unknown"
    assert masses["as it is"].mean > 0
    assert comparison.units["filled_mass_kg"] == "kg"
