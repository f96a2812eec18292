#!/usr/bin/env python3
"""Draws unrolled maps of a mould's inner face, over angle and height: `stress_maps.py FOLDER`.

Of the CSV files that wall_stress --out FOLDER leaves, one PNG beside each; of a run with
`output.maps = true`, FOLDER/mould_map.png: the mean over its last gyration. Traction is that of the
mix on the wall, positive where it presses; axial traction is positive upwards."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def draw(picture, title, angle, height, maps):
    """`angle` [deg], `height` [mm], `maps`: words and values of each panel."""
    # The face once around: what lies at the seam is repeated on its other side.
    seam, far = angle < -90, angle > 90
    around = np.concatenate([angle, angle[seam] + 360, angle[far] - 360])
    up = np.concatenate([height, height[seam], height[far]])
    figure, axes = plt.subplots(len(maps), 1, figsize=(8, 3.5 * len(maps)), sharex=True,
                                layout="constrained")
    for ax, (words, panel) in zip(axes, maps):
        values = np.concatenate([panel, panel[seam], panel[far]])
        middle, half = (values.max() + values.min()) / 2, np.ptp(values) / 2
        half = max(half, 1e-3 * abs(middle), 1e-12)  # an even map is one colour
        levels = np.linspace(middle - 1.001 * half, middle + 1.001 * half, 25)
        filled = ax.tricontourf(around, up, values, levels=levels, cmap="viridis")
        figure.colorbar(filled, ax=ax, label=words, format="%.4g")
        ax.set_ylabel("height [mm]")
    axes[-1].set_xlabel("angle [deg]")
    axes[-1].set_xlim(-180, 180)
    figure.suptitle(title)
    figure.savefig(picture, dpi=120)
    plt.close(figure)


def draw_case(csv):
    table = np.genfromtxt(csv, delimiter=",", names=True)
    draw(csv.with_suffix(".png"), csv.stem, table["angle_deg"], 1e3 * table["height_m"],
         [("traction, outwards [kPa]", 1e-3 * table["traction_Pa"]),
          ("hoop stress, inner face [kPa]", 1e-3 * table["hoop_stress_Pa"])])


def draw_run(folder):
    import h5py

    with h5py.File(folder / "results.h5") as file:
        if "walls/mould" not in file:
            sys.exit(f"{folder}/results.h5: no maps; the scene needs output.maps = true and a "
                     "gyration that is done")
        wall = {name: values[:] for name, values in file["walls/mould"].items()}
    last = wall["gyration"] == wall["gyration"].max()
    maps = [("normal traction [kPa]", "normal_traction"), ("axial traction [kPa]", "axial_traction"),
            ("hoop stress, inner face [kPa]", "hoop_stress")]
    draw(folder / "mould_map.png",
         f"Mix on the mould, mean over gyration {wall['gyration'].max():.0f}",
         np.degrees(wall["angle"][last]), 1e3 * wall["height"][last],
         [(words, 1e-3 * wall[name][last]) for words, name in maps if name in wall])


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: stress_maps.py FOLDER")
    place = Path(sys.argv[1])
    if (place / "results.h5").exists():
        draw_run(place)
    else:
        for path in sorted(place.glob("*.csv")):
            draw_case(path)
