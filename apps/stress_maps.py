#!/usr/bin/env python3
"""Draws the unrolled maps that wall_stress --out FOLDER leaves: traction and hoop stress of a
mould's inner face over angle and height, one PNG beside each CSV."""

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np


def draw(csv):
    table = np.genfromtxt(csv, delimiter=",", names=True)
    angle, height = table["angle_deg"], 1e3 * table["height_m"]
    # The face once around: what lies at the seam is repeated on its other side.
    seam = angle < -90
    far = angle > 90
    around = np.concatenate([angle, angle[seam] + 360, angle[far] - 360])
    up = np.concatenate([height, height[seam], height[far]])
    figure, axes = plt.subplots(2, 1, figsize=(8, 7), sharex=True, layout="constrained")
    for ax, name, title in zip(axes, ("traction_Pa", "hoop_stress_Pa"),
                               ("traction, outwards [kPa]", "hoop stress, inner face [kPa]")):
        values = 1e-3 * np.concatenate([table[name], table[name][seam], table[name][far]])
        if np.ptp(values) <= 1e-9 * max(1e-30, np.abs(values).max()):
            values = values + np.linspace(0, 1e-6, values.size) * max(1e-9, np.abs(values).max())
        map_ = ax.tricontourf(around, up, values, levels=24, cmap="viridis")
        figure.colorbar(map_, ax=ax, label=title)
        ax.set_ylabel("height [mm]")
    axes[1].set_xlabel("angle [deg]")
    axes[1].set_xlim(-180, 180)
    figure.suptitle(csv.stem)
    figure.savefig(csv.with_suffix(".png"), dpi=120)
    plt.close(figure)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: stress_maps.py FOLDER")
    for csv in sorted(Path(sys.argv[1]).glob("*.csv")):
        draw(csv)
