#!/usr/bin/python3
"""Draws unrolled maps of a mould's inner face, over angle and height: `stress_maps.py FOLDER`.

Of the CSV files that wall_stress --out FOLDER leaves, one PNG beside each; of a run with
`output.maps = true`, FOLDER/mould_map.png: the mean over its last gyration. Traction is that of the
mix on the wall, positive where it presses; axial traction is positive upwards."""

import sys
from pathlib import Path

import matplotlib
import numpy as np

from plots import walls
from plots.run import Run
from plots.style import STYLE


def draw_run(folder):
    page = walls.walls(Run(folder))
    if page is None:
        sys.exit(f"{folder}/results.h5: no maps; the scene needs output.maps = true and a "
                 "gyration that is done")
    page.savefig(folder / "mould_map.png", dpi=120)


def draw_case(csv):
    table = np.genfromtxt(csv, delimiter=",", names=True)
    walls.steel_alone(csv.stem, table).savefig(csv.with_suffix(".png"), dpi=120)


if __name__ == "__main__":
    if len(sys.argv) != 2:
        sys.exit("usage: stress_maps.py FOLDER")
    place = Path(sys.argv[1])
    with matplotlib.rc_context(STYLE):
        if (place / "results.h5").exists():
            draw_run(place)
        else:
            for path in sorted(place.glob("*.csv")):
                draw_case(path)
