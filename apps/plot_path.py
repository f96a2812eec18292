#!/usr/bin/python3
"""Draws contact paths: `plot_path.py OUT.csv [MORE.csv ...] --out PICTURE.png`.

The tables are those of contact_path; several are laid over each other."""

import argparse
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

from plots.errors import InputError, exit_status_of
from plots.style import INK, OF_CURVES, STYLE, save
from plots.tables import read_table

COLOURS = [*OF_CURVES, "#e08214", "#4d4d4d"]
COLUMNS = ["time_s", "overlap_m", "shear_m", "force_N", "binder_N", "stone_N", "shear_N",
           "bonded", "broken"]


def read(path):
    """The columns of a table, lengths in um."""
    columns = read_table(path, COLUMNS, "contact_path")
    for name in ("overlap_m", "shear_m"):
        columns[name] = columns[name] * 1e6
    return columns


def break_points(columns):
    """Rows at which a bond lets go or a stone breaks."""
    let_go = np.flatnonzero(np.diff(columns["bonded"]) < 0) + 1
    broke = np.flatnonzero(np.diff(columns["broken"]) > 0) + 1
    return let_go, broke


def draw_parts(axes, x, columns, name, colour):
    axes.plot(columns[x], columns["force_N"], color=colour, label=name)
    if np.any(columns["binder_N"]) and np.any(columns["stone_N"]):
        axes.plot(columns[x], columns["binder_N"], color=colour, linewidth=0.9, linestyle="--",
                  label=f"{name}, binder")
    let_go, broke = break_points(columns)
    for rows, marker, event in ((let_go, "o", "bond lets go"), (broke, "x", "stone breaks")):
        if len(rows):
            axes.plot(columns[x][rows - 1], columns["force_N"][rows - 1], marker, color=INK,
                      label=f"{name}, {event}")


def picture(paths):
    figure, axes = plt.subplots(2, 2, figsize=(11, 8), layout="constrained")
    for k, (name, columns) in enumerate(paths.items()):
        colour = COLOURS[k % len(COLOURS)]
        draw_parts(axes[0, 0], "overlap_m", columns, name, colour)
        draw_parts(axes[0, 1], "time_s", columns, name, colour)
        axes[1, 0].plot(columns["shear_m"], columns["shear_N"], color=colour, label=name)
        axes[1, 1].plot(columns["time_s"], columns["shear_N"], color=colour, label=name)
    for plot, title, x, y in (
            (axes[0, 0], "Normal force over overlap", "overlap [um]", "force [N]"),
            (axes[0, 1], "Normal force over time", "time [s]", "force [N]"),
            (axes[1, 0], "Shear loop", "shear displacement [um]", "shear force [N]"),
            (axes[1, 1], "Shear force over time", "time [s]", "shear force [N]")):
        plot.set_title(title)
        plot.set_xlabel(x)
        plot.set_ylabel(y)
        plot.axhline(0, color=INK, linewidth=0.8)
    axes[0, 0].legend()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tables", nargs="+", type=pathlib.Path, help="written by contact_path")
    parser.add_argument("--out", type=pathlib.Path,
                        help="picture, .png or .svg; beside the first table if not given")
    options = parser.parse_args()
    out = options.out or options.tables[0].with_suffix(".png")
    if out.suffix not in (".png", ".svg"):
        raise InputError(f"{out}: expected a picture, .png or .svg, found the ending "
                         f"\"{out.suffix}\"; choose another --out")
    paths = {str(path.with_suffix("")): read(path) for path in options.tables}
    with plt.rc_context(STYLE):
        save(picture(paths), out, dpi=150)


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
