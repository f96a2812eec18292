#!/usr/bin/python3
"""Draws unrolled maps of a mould's inner face, over angle and height: `stress_maps.py FOLDER`.

Of the tables that wall_stress --out FOLDER leaves, one PNG beside each; of a run with
`output.maps = true`, FOLDER/mould_map.png: the mean over its last gyration. Traction is that of the
mix on the wall, positive where it presses; axial traction is positive upwards."""
import argparse
import pathlib
import sys

import matplotlib

from plots import walls
from plots.errors import InputError, exit_status_of
from plots.folders import RUN, TABLES, expect
from plots.run import Run
from plots.style import STYLE, save
from plots.tables import read_table

COLUMNS = ["angle_deg", "height_m", "traction_Pa", "hoop_stress_Pa"]


def draw_run(folder):
    page = walls.walls(Run(folder))
    if page is None:
        raise InputError(f"{folder / 'results.h5'}: expected maps of the mould, found none; run it "
                         "with output.maps = true until a gyration is done")
    save(page, folder / "mould_map.png", dpi=120)


def draw_cases(folder):
    tables = {path: read_table(path, COLUMNS, "wall_stress")
              for path in sorted(folder.glob("*.csv"))}
    for path, table in tables.items():
        save(walls.steel_alone(path.stem, table), path.with_suffix(".png"), dpi=120)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path, help="of a run, or of wall_stress --out")
    folder = parser.parse_args().folder
    draw = draw_run if expect(folder, RUN, TABLES) == RUN else draw_cases
    with matplotlib.rc_context(STYLE):
        draw(folder)


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
