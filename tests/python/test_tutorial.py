"""The tutorial sample_tools/python/shoe_speed.py, with two speeds on a coarse scene."""
import importlib.util
import os
import subprocess
import sys
from pathlib import Path

import pytest

TUTORIAL = Path(__file__).parents[2] / "sample_tools" / "python" / "shoe_speed.py"


@pytest.fixture
def tutorial(monkeypatch, tmp_path):
    """The tutorial as a module, called with the folder `tmp_path`."""
    pytest.importorskip("matplotlib")
    specification = importlib.util.spec_from_file_location("shoe_speed", TUTORIAL)
    module = importlib.util.module_from_spec(specification)
    specification.loader.exec_module(module)
    monkeypatch.setattr(module, "SPEEDS", (0.2, 0.4))
    monkeypatch.setattr(sys, "argv", [str(TUTORIAL), str(tmp_path)])
    return module


def test_the_tutorial_draws_its_chart_and_computes_once(tutorial, scene, tmp_path, capsys):
    scene.write(tmp_path / "die")
    tutorial.main()
    printed = capsys.readouterr().out
    assert "\n0.20 m/s  " in printed and "\n0.40 m/s  " in printed
    chart, runs = tmp_path / "shoe_speed.png", sorted(tmp_path.glob("*_m_s/results.h5"))
    assert chart.stat().st_size > 0 and len(runs) == 2
    written = [run.stat().st_mtime_ns for run in runs]
    tutorial.main()
    assert [run.stat().st_mtime_ns for run in runs] == written


def test_without_matplotlib_the_tutorial_says_what_to_install(tmp_path):
    (tmp_path / "matplotlib.py").write_text("raise ImportError")
    path = os.pathsep.join([str(tmp_path), os.environ.get("PYTHONPATH", "")])
    done = subprocess.run([sys.executable, str(TUTORIAL)], env={**os.environ, "PYTHONPATH": path}, cwd=tmp_path,
                          capture_output=True, text=True)
    assert done.returncode == 1
    assert done.stderr.count("\n") == 1 and "python3-matplotlib" in done.stderr
