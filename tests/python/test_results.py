"""Results as arrays: without copies, read-only, and the numbers of the files."""
import ast
import gc
import json
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest

import diefill
from diefill import _results


def test_arrays_show_the_memory_of_the_results(folder):
    results = diefill.read(folder)
    first, second = results.powder.position, results.powder.position
    assert first.shape == (len(results.powder), 3)
    assert first.__array_interface__["data"][0] == second.__array_interface__["data"][0]
    with pytest.raises(ValueError):
        first[0, 0] = 1


def test_arrays_outlive_the_results(folder):
    results = diefill.read(folder)
    position, copy = results.powder.position, results.powder.position.copy()
    field = next(iter(results.sections.values())).field
    values = field.values.copy()
    del results
    gc.collect()
    np.testing.assert_array_equal(position, copy)
    np.testing.assert_array_equal(field.values, values)


def test_numbers_are_those_of_the_file(folder):
    h5py = pytest.importorskip("h5py")
    results = diefill.read(folder)
    with h5py.File(folder / "results.h5") as file:
        for name in ("position", "orientation", "velocity", "id"):
            np.testing.assert_array_equal(getattr(results.powder, name), file["powder"][name][:])
        np.testing.assert_array_equal(results.solid_fraction.open, file["solid_fraction/open"][:] == 1)
        np.testing.assert_array_equal(results.contact_stress.normal, file["contact_stress/normal"][:])


def test_figures_are_those_of_the_report(folder):
    report = json.loads((folder / "report.json").read_text())
    results = diefill.read(folder)
    assert results.figures["fill_ratio"] == report["fill_ratio"]
    assert results.state_hash == report["state_hash"]
    assert diefill.figure_meaning("filled_mass_kg")[0] == "kg"


@pytest.mark.parametrize("name, said", [("fill_ration", "did you mean 'fill_ratio'"), ("typo", "Results.figures"),
                                        (3, "of type int"), ("\ud800", "no figure"), (None, "of type NoneType")])
def test_a_figure_that_does_not_exist_is_bad_input(name, said):
    with pytest.raises(diefill.BadInput, match=re.escape(said)) as error:
        diefill.figure_meaning(name)
    assert "\n" not in str(error.value)


def test_figures_of_cavities_and_items_have_a_meaning():
    assert diefill.figure_meaning("cavity_2_fill_ratio") == diefill.figure_meaning("fill_ratio")
    assert diefill.figure_meaning("slope_of_left_heap_deg")[0] == "deg"


@pytest.mark.parametrize("entries, name, said", [
    ("figures", "fill_ration", "'fill_ration': no such figure; did you mean 'fill_ratio'?"),
    ("maps", "nix", "'nix': no such map; allowed: 'solid fraction'"), ("tools", 3, "no such tool; allowed: 'die'"),
    ("probes", "nix", "no such probe; there is none")])
def test_a_name_that_is_not_there_is_answered_with_those_that_are(folder, entries, name, said):
    with pytest.raises(KeyError, match=re.escape(said)) as error:
        getattr(diefill.read(folder), entries)[name]
    assert "\n" not in str(error.value)


def test_entries_by_name_are_a_dict(folder):
    figures = diefill.read(folder).figures
    assert isinstance(figures, dict) and figures.get("nix") is None and "nix" not in figures
    for copy in (pickle.loads(pickle.dumps(figures)), json.loads(json.dumps(figures))):
        np.testing.assert_equal(dict(copy), dict(figures))


def test_profiles_of_one_quantity_over_two_axes_are_both_there(scene, tmp_path):
    ring = diefill.new(tmp_path / "ring", kind="ring").file
    sizes = ('sizes = {distribution = "classes", classes = [{diameter = "2 mm", share = 0.5}, {diameter = "3 mm", '
             'share = 0.5}]}')
    ring.write_text(re.sub(r"^grain_diameter = .*$", sizes, ring.read_text(), flags=re.MULTILINE))
    quick = {key: value for key, value in scene.changes.items() if key != "powder.grain_diameter"}
    poured = {"pour.from": ["5.2 mm", "-3 mm", "-9.9 mm"], "pour.to": ["10.4 mm", "3 mm", "0 mm"],
              "pour.fill_height": "4 mm", "step": [{"kind": "wait", "duration": "1 ms"}], "walls.spacing": 1.6}
    profiles = diefill.Scene(ring, {**quick, **poured}).run(tmp_path / "out", threads=1).profiles
    assert profiles["fill level"].x_name == "azimuth"
    for axis in ("height", "azimuth"):
        assert profiles[f"mean grain diameter over {axis}"].x_name == axis
    assert "mean grain diameter" not in profiles


def test_a_column_of_a_probe_that_is_no_text_is_refused_in_one_line(scene, tmp_path):
    file = Path(scene.file).with_name("probed.toml")
    probe = '\n[[probe]]\nname = "mass"\nquantity = "filled mass"\ninterval = "10 ms"\n'
    file.write_text(Path(scene.file).read_text() + probe)
    probed = diefill.Scene(file, {**scene.changes, "numerics.max_time": "0.05 s"})
    with pytest.warns(diefill.UnfinishedWarning):
        mass = probed.run(tmp_path / "out", threads=1).probes["mass"]
    assert len(mass["filled mass"]) == len(mass.values)
    with pytest.raises(TypeError, match="expected its name as a text") as error:
        mass[3]
    assert "\n" not in str(error.value)


def test_fields_lie_on_their_grids(folder):
    section = next(iter(diefill.read(folder).sections.values()))
    field = section.field
    assert field.values.shape == (len(field.second), len(field.first))
    assert 0.2 < np.nanmax(field.values) < 1
    assert np.linalg.norm(section.normal) == pytest.approx(1)


def test_instants_ascend(folder):
    instants = diefill.read(folder).instants
    times = [instant.time for instant in instants]
    assert len(times) > 1 and times == sorted(times)
    assert instants[0].position.shape == (len(instants[0]), 3)


def test_schedule_checks_and_summary_are_those_of_the_report(folder):
    report = json.loads((folder / "report.json").read_text())
    results = diefill.read(folder)
    stated, stages = report["solid_fraction"], results.stages
    assert results.summary.grains == stated["grains"]
    assert stated["mean"] is None or results.summary.mean == stated["mean"]
    assert any("passage" in stage.words and stage.tool in results.tools for stage in stages)
    assert all(one.start <= one.end for one in stages)
    assert set(results.tool_checks) == set(results.tools)
    assert all(check.volume > 0 and check.file.endswith(".stl") for check in results.tool_checks.values())
    assert results.other_cavities == [] and len(results.instants[0].kind) == 0


def test_objects_show_what_they_hold(folder):
    results = diefill.read(folder)
    name, tool = next(iter(results.tools.items()))
    assert repr(tool).startswith(f"<diefill.Tool {name} ({tool.role}): {len(tool.triangles)} triangles")
    assert repr(results.powder) == f"<diefill.Powder {len(results.powder)} grains at {results.powder.time:g} s>"
    assert any("passage" in repr(stage) for stage in results.stages)
    objects = [results.cavity, results.solid_fraction, results.contact_stress, results.summary, results.instants[0],
               *results.maps.values(), *results.sections.values(), *results.profiles.values(),
               *results.tool_checks.values()]
    for one in objects:
        assert repr(one).startswith(f"<diefill.{type(one).__name__} ") and "object at" not in repr(one)


def test_missing_results_are_bad_input(tmp_path):
    with pytest.raises(diefill.BadInput, match="no such results file") as error:
        diefill.read(tmp_path)
    assert "\n" not in str(error.value)


def test_results_of_a_run_that_has_not_ended_are_bad_input(tmp_path):
    (tmp_path / "checkpoint.bin").write_bytes(b"state")
    with pytest.raises(diefill.BadInput, match="not reached its end.*--resume"):
        diefill.read(tmp_path)


@pytest.mark.parametrize("directory", [None, 5, "", "a\0b", "\ud800", b"a\xff", ["out"]])
def test_what_names_no_directory_is_bad_input_in_one_line(directory):
    for read in (diefill.read, diefill.read_comparison):
        with pytest.raises(diefill.BadInput, match=".") as error:
            read(directory)
        assert "\n" not in str(error.value)


@pytest.mark.parametrize("text", ["", "[]", "{}", "null", '{"title": 1}', "\xff", "[" * 100000])
def test_a_damaged_comparison_is_bad_input(tmp_path, text):
    (tmp_path / "comparison.json").write_text(text, encoding="latin-1")
    with pytest.raises(diefill.BadInput, match="comparison.json: damaged"):
        diefill.read_comparison(tmp_path)


def test_everything_in_the_module_is_explained():
    stub = ast.parse((Path(diefill.__file__).parent / "_results.pyi").read_text())
    for node in (one for one in stub.body if isinstance(one, ast.ClassDef) and not one.bases):
        assert ast.get_docstring(node) and getattr(_results, node.name).__doc__, node.name
        for member, after in zip(node.body, node.body[1:] + [None]):
            if isinstance(member, ast.FunctionDef):
                assert ast.get_docstring(member), f"{node.name}.{member.name}"
                assert getattr(_results, node.name).__dict__[member.name].__doc__, f"{node.name}.{member.name}"
            elif isinstance(member, ast.AnnAssign):
                assert isinstance(after, ast.Expr), f"{node.name}.{member.target.id}"
                name = member.target.id
                assert getattr(_results, node.name).__dict__[name].__doc__, f"{node.name}.{name}"


@pytest.mark.parametrize("files, said", [({}, "build it with: sh app/build.sh --target _results"),
                                         ({"_results.so": ""}, "use the Python that it was built for"),
                                         ({"_results.so": "", "numpy.py": "raise ImportError('none')"}, "with NumPy")])
def test_a_python_that_cannot_load_the_package_is_told_why_in_one_line(tmp_path, files, said):
    package = tmp_path / "diefill"
    package.mkdir()
    for file in Path(diefill.__file__).parent.glob("*.py"):
        (package / file.name).write_text(file.read_text())
    for name, text in files.items():
        place = package / f"{name[:-3]}.other.so" if name.endswith(".so") else tmp_path / name
        place.write_text(text)
    done = subprocess.run([sys.executable, "-c", "import diefill"], cwd=tmp_path, capture_output=True, text=True,
                          env={**os.environ, "PYTHONPATH": str(tmp_path)})
    assert done.returncode == 1
    last = done.stderr.splitlines()[-1]
    assert last.startswith("ImportError: diefill: ") and said in last


def test_types_are_stated_for_everything_in_the_module():
    stub = (Path(diefill.__file__).parent / "_results.pyi").read_text()
    for name, kind in vars(_results).items():
        if name.startswith("_"):
            continue
        assert re.search(rf"(class|def) {name}\b", stub), name
        for member in vars(kind) if isinstance(kind, type) else ():
            assert member.startswith("_") or re.search(rf"\b{member}\b", stub), f"{name}.{member}"
