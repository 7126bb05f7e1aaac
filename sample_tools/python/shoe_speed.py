#!/usr/bin/env python3
"""How fast may the shoe go? Sweeps its speed over a small rectangular die and plots the fill ratio.

    python3 shoe_speed.py [FOLDER]     # scene, runs and shoe_speed.png go there; default: out/shoe_speed

Needs python3-diefill and matplotlib. A second call takes finished runs from the folder and computes nothing.
"""
import sys
from pathlib import Path

try:
    import matplotlib
except ImportError:
    sys.exit("shoe_speed.py: matplotlib is missing; install it with: apt install python3-matplotlib")

matplotlib.use("Agg")
import matplotlib.pyplot as plt

import diefill

SPEEDS = (0.05, 0.1, 0.2, 0.3, 0.4)  # m/s


def fill_ratio(scene: diefill.Scene, speed: float, folder: Path) -> float:
    """Share of a full die after one passage at `speed` (m/s)."""
    if not (folder / "results.h5").exists():
        def show(share: float, doing: str) -> None:
            print(f"\r{speed} m/s: {100 * share:3.0f} % {doing[:60]:60}", end="", flush=True)

        scene.changed({"step.1.velocity": f"{speed} m/s"}).run(folder, callback=show)
        print()
    return diefill.read(folder).figures["fill_ratio"]


def main() -> None:
    folder = Path(sys.argv[1] if len(sys.argv) > 1 else "out/shoe_speed")
    file = folder / "die" / "fill.toml"
    scene = diefill.Scene(file) if file.exists() else diefill.new(folder / "die", kind="rectangular_die")
    critical = scene.estimate()["openings"][0]["critical_speed_one_crossing_m_per_s"]
    ratios = [fill_ratio(scene, speed, folder / f"{speed}_m_s") for speed in SPEEDS]

    figure, axes = plt.subplots(figsize=(6, 4), layout="constrained")
    axes.plot(SPEEDS, ratios, "o-", color="black", label="simulated, one passage")
    if critical is not None:
        axes.axvline(critical, color="gray", linestyle="--", label="fastest that fills it, by formula")
    axes.set(xlabel="shoe speed / (m/s)", ylabel="fill ratio", xlim=(0, None), ylim=(0, None))
    axes.legend()
    figure.savefig(folder / "shoe_speed.png", dpi=150)
    for speed, ratio in zip(SPEEDS, ratios):
        print(f"{speed:4.2f} m/s  {ratio:.3f}")
    print("look at", folder / "shoe_speed.png")


if __name__ == "__main__":
    main()
