"""Scenes: changed, estimated, planned, run, stopped and compared."""
import pytest

import diefill


def test_changes_leave_the_scene_as_it_is(scene):
    slow = scene.changed({"step.1.velocity": "0.1 m/s"})
    assert "step.1.velocity" not in scene.changes
    assert slow.estimate()["shoe"]["speed_m_per_s"] == pytest.approx(0.1)


def test_a_wrong_key_is_bad_input_in_one_line(scene, tmp_path):
    with pytest.raises(diefill.BadInput, match="grain_size") as error:
        scene.changed({"powder.grain_size": "1 mm"}).run(tmp_path / "out")
    assert "\n" not in str(error.value)
    assert not (tmp_path / "out").exists()


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
    variants = {"as it is": {}, "fast": {"step.1.velocity": "0.15 m/s"}}
    comparison = scene.compare(variants, tmp_path / "out")
    masses = comparison.measure("filled_mass_kg")
    assert comparison.variants == list(variants) == list(masses)
    assert masses["fast"].verdict == "scatter unknown"
    assert masses["as it is"].mean > 0
