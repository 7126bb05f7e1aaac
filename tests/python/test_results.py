"""Results as arrays: without copies, read-only, and the numbers of the files."""
import gc
import json
import re
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


def test_missing_results_are_bad_input(tmp_path):
    with pytest.raises(diefill.BadInput, match="no such results file") as error:
        diefill.read(tmp_path)
    assert "\n" not in str(error.value)


def test_types_are_stated_for_everything_in_the_module():
    stub = (Path(diefill.__file__).parent / "_results.pyi").read_text()
    for name, kind in vars(_results).items():
        if name.startswith("_"):
            continue
        assert re.search(rf"(class|def) {name}\b", stub), name
        for member in vars(kind) if isinstance(kind, type) else ():
            assert member.startswith("_") or re.search(rf"\b{member}\b", stub), f"{name}.{member}"
