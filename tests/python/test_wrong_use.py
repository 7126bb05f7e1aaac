"""Wrong use of scenes: an exception with one line, and nothing started or overwritten."""
import enum
import os
import signal

import pytest

import diefill
from diefill import program
from diefill.scene import _lines


def line_of(error):
    text = str(error.value)
    assert text and "\n" not in text
    return text


@pytest.mark.parametrize("path", [None, 5, "", ["out"], "a\0b", "\ud800"])
def test_what_names_no_path_is_bad_input_before_anything_runs(scene, tmp_path, monkeypatch, path):
    monkeypatch.chdir(tmp_path)
    for use in (diefill.Scene, diefill.new, scene.run, scene.write, lambda out: scene.compare({"a": {}}, out)):
        with pytest.raises(diefill.BadInput) as error:
            use(path)
        line_of(error)
    assert list(tmp_path.iterdir()) == []


def test_a_path_of_bytes_is_the_path_that_it_names(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    diefill.new("Gesenk für Öl".encode())
    assert [one.name for one in tmp_path.iterdir()] == ["Gesenk für Öl"]


@pytest.mark.parametrize("name", ["-x", "--help", "--version"])
def test_names_that_look_like_options_are_names(tmp_path, monkeypatch, name):
    monkeypatch.chdir(tmp_path)
    assert diefill.new(name).file.exists() and (tmp_path / name / "fill.toml").exists()
    os.rename(tmp_path / name / "fill.toml", tmp_path / name / "-f.toml")
    monkeypatch.chdir(tmp_path / name)
    assert diefill.Scene("-f.toml").estimate()["openings"]


@pytest.mark.parametrize("changes", ["seed = 1", ["seed"], 5, [("seed", 1)]])
def test_changes_that_are_no_mapping_are_bad_input(scene, changes):
    for use in (lambda: scene.changed(changes), lambda: diefill.Scene(scene.file, changes),
                lambda: scene.compare({"a": changes}, "out")):
        with pytest.raises(diefill.BadInput, match="expected a mapping") as error:
            use()
        line_of(error)


@pytest.mark.parametrize("key", ["", 5, None, "seed = 3 #", "seed\nx", "a..b", "[[step]]", "a = {b = 1}\n#"])
def test_a_key_that_names_none_is_bad_input(scene, key):
    with pytest.raises(diefill.BadInput, match="expected names joined by dots") as error:
        scene.changed({key: 3}).estimate()
    line_of(error)


@pytest.mark.parametrize("key", ["seed", "step.1.velocity", 'tool."core rod".position', "tool . 'a=b' . x", "a-b_c.1"])
def test_dotted_keys_of_toml_are_written_as_they_are(key):
    assert _lines({key: 1}) == [f"{key} = 1"]


def test_values_that_no_command_line_can_hold_are_bad_input(scene):
    endless = []
    endless.append(endless)
    for value, said in ((endless, "holds itself"), ("\ud800", "surrogate"), ("x" * 200000, "command line")):
        with pytest.raises(diefill.BadInput, match=said) as error:
            scene.changed({"title": value}).estimate()
        line_of(error)


def test_a_text_of_an_enumeration_is_its_text():
    class Speed(str, enum.Enum):
        SLOW = "0.1 m/s"

    assert _lines({"step.1.velocity": Speed.SLOW}) == ['step.1.velocity = "0.1 m/s"']


def test_a_callback_that_cannot_be_called_is_bad_input_before_the_run(scene, tmp_path):
    with pytest.raises(diefill.BadInput, match="callback: found 5"):
        scene.run(tmp_path / "out", callback=5)
    assert not (tmp_path / "out").exists()


@pytest.mark.parametrize("variants", [{}, [], ["a"], None, {"a": None}, {0.1: {}}])
def test_a_comparison_without_named_variants_is_bad_input(scene, tmp_path, variants):
    with pytest.raises(diefill.BadInput, match="^variant") as error:
        scene.compare(variants, tmp_path / "out")
    line_of(error)
    assert list(tmp_path.iterdir()) == []


def test_a_comparison_replaces_no_file_that_it_has_not_written(scene, tmp_path):
    mine = scene.write(tmp_path / "die").rename(tmp_path / "speeds.toml")
    text = mine.read_text()
    with pytest.raises(diefill.BadInput, match="speeds.toml: found a file that compare has not written"):
        diefill.Scene(mine).compare({"slow": {"step.1.velocity": "0.1 m/s"}}, tmp_path / "speeds")
    assert mine.read_text() == text


def test_a_comparison_names_its_scene_file_after_the_folder(scene, tmp_path):
    for _ in range(2):  # its own file is written again
        with pytest.raises(diefill.BadInput, match="stap"):
            scene.compare({"a": {"stap.1": "1 m/s"}}, f"{tmp_path}/out/")
    assert [one.name for one in tmp_path.iterdir() if one.is_file()] == ["out.toml"]


def test_a_comparison_whose_runs_fail_says_which_and_keeps_the_others(scene, tmp_path):
    variants = {"soft": {"powder.reduced_modulus": "10 kPa"}, "as it is": {}}
    with pytest.raises(diefill.OutOfRange, match='^"soft", seed 1 failed: ') as error:
        scene.compare(variants, tmp_path / "out")
    assert line_of(error).count("seed") == 1
    masses = diefill.read_comparison(tmp_path / "out").measure("filled_mass_kg")
    assert masses["soft"].mean is None and masses["as it is"].mean > 0
    with pytest.raises(KeyError, match="fill_ratio"):
        diefill.read_comparison(tmp_path / "out").measure("fil_ratio")


@pytest.mark.parametrize("script, said", [
    ("", "printed no JSON"), ("exit 1", "exit code 1"), ("kill -KILL $$", "SIGKILL; memory"),
    ("kill -TERM $$", "SIGTERM"), ("echo some note >&2; kill -KILL $$", "SIGKILL")])
def test_a_program_that_ends_in_another_way_has_failed(scene, tmp_path, monkeypatch, script, said):
    (tmp_path / "program").write_text(f"#!/bin/sh\n{script}\n")
    (tmp_path / "program").chmod(0o755)
    monkeypatch.setenv("DIEFILL_PROGRAM", str(tmp_path / "program"))
    with pytest.raises(diefill.Failed, match=said) as error:
        scene.estimate()
    line_of(error)


@pytest.mark.parametrize("path", ["/nowhere/diefill", "/tmp"])
def test_a_program_that_cannot_be_started_has_failed(scene, monkeypatch, path):
    monkeypatch.setenv("DIEFILL_PROGRAM", path)
    with pytest.raises(diefill.Failed, match=f"{path}: cannot be started.*DIEFILL_PROGRAM") as error:
        scene.estimate()
    line_of(error)


def test_signals_without_a_name_have_their_number():
    assert program._signal_name(signal.SIGKILL) == "SIGKILL"
    assert program._signal_name(1000) == "signal 1000"
