#!/usr/bin/python3
"""Draws a run at a glance: `plot_run.py DIR` makes DIR/run.png from DIR/results.h5."""

import argparse
import copy
import pathlib
import sys

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

INK, BLUE, RED = "#222222", "#2166ac", "#b2182b"

# Stored unit: the unit that is shown, and the factor between them.
SHOWN_AS = {"Pa": ("kPa", 1e-3), "m": ("mm", 1e3), "1": ("-", 1)}

STYLE = {
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.ymargin": 0.08,
    "grid.color": "#e6e6e6",
    "legend.frameon": False,
    "lines.linewidth": 1.5,
}


class Run:
    """The histories of results.h5, in the units that are shown."""

    def __init__(self, path):
        with h5py.File(path, "r") as file:
            self.columns = {name: column[:] for name, column in file["history"].items()}
            self.units = {name: column.attrs["unit"] for name, column in file["history"].items()}
            self.provenance = dict(file["provenance"].attrs)
            self.diameter = file["mould/diameter"][0] if "mould/diameter" in file else None

    def shown(self, name):
        return self.columns[name] * SHOWN_AS.get(self.units[name], (None, 1))[1]

    def since_first_gyration(self):
        """The same run without the pressure ramp, in which nothing gyrates yet."""
        gyrating = copy.copy(self)
        ramp = max(0, np.count_nonzero(self.columns["gyration"] <= 0) - 1)
        gyrating.columns = {name: column[ramp:] for name, column in self.columns.items()}
        return gyrating

    def unit(self, name):
        return SHOWN_AS.get(self.units[name], (self.units[name],))[0]

    def label(self, text, name):
        return f"{text} [{self.unit(name)}]"


def draw(axes, run, x, curves, title, quantity):
    """Draws curves, each a (column, legend, colour), over the column and words of `x`."""
    for column, legend, colour in curves:
        axes.plot(run.shown(x[0]), run.shown(column), color=colour, label=legend)
    axes.set_title(title)
    axes.set_xlabel(run.label(x[1], x[0]))
    axes.set_ylabel(run.label(quantity, curves[0][0]))
    if len(curves) > 1:
        axes.margins(y=0.3)  # room for the legend
        axes.legend(loc="upper center", ncols=2)


def draw_fractured(axes, run, x):
    axes.step(run.shown(x[0]), run.columns["fractured"], where="post", color=INK)
    axes.set_title("Fractured stones")
    axes.set_xlabel(run.label(x[1], x[0]))
    axes.set_ylabel("stones [-]")
    most = max(1, run.columns["fractured"].max())
    axes.set_ylim(-0.05 * most, 1.1 * most)
    axes.yaxis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))


def draw_pressure(axes, run, x):
    """What the ram imposes and, where the mould is known, what the mix answers."""
    if run.diameter:
        answer = run.columns["head_force"] / (np.pi / 4 * run.diameter**2)
        factor = SHOWN_AS[run.units["ram_pressure"]][1]
        axes.plot(run.shown(x[0]), answer * factor, color=RED, linewidth=0.8,
                  label="mix on head, force / section")
    ram = ("ram_pressure", "imposed at the ram", BLUE)
    draw(axes, run, x, [ram], "Pressure", "pressure")
    axes.legend()


def draw_gyratory(figure, run):
    gyration, time = ("gyration", "gyrations"), ("time", "time")
    axes = figure.subplots(3, 2)
    gyrating = run.since_first_gyration()
    draw(axes[0, 0], gyrating, gyration, [("air_voids", None, BLUE)], "Compaction", "air voids")
    draw(axes[0, 1], gyrating, gyration, [("air_voids_decrease", None, BLUE)],
         "Decrease of air voids", "decrease")
    draw_pressure(axes[1, 0], run, time)
    draw(axes[1, 1], gyrating, gyration, [("commanded_angle", "commanded", BLUE),
                                          ("internal_angle", "internal", RED)],
         "Angle", "angle")
    draw_fractured(axes[2, 0], gyrating, gyration)
    draw(axes[2, 1], gyrating, gyration, [("coordination", None, BLUE)], "Coordination",
         "contacts per stone")


def draw_flow_test(figure, run):
    displacement = ("displacement", "strip displacement")
    axes = figure.subplots(3, 1, sharex=True)
    draw(axes[0], run, displacement, [("pressure", None, BLUE)], "Pressure under the strip",
         "pressure")
    draw(axes[1], run, displacement, [("uplift", None, BLUE)], "Uplift beside the strip", "uplift")
    axes[1].axhline(0, color=INK, linewidth=0.8)
    draw_fractured(axes[2], run, displacement)
    for upper in axes[:2]:
        upper.set_xlabel("")


def picture(run, title):
    gyratory = "gyration" in run.columns
    figure = plt.figure(figsize=(10, 10) if gyratory else (7, 9), layout="constrained")
    figure.suptitle(title, x=0.01, ha="left", fontsize=13)
    (draw_gyratory if gyratory else draw_flow_test)(figure, run)
    return figure


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("dir", type=pathlib.Path, metavar="DIR", help="folder of a run")
    options.add_argument("--out", type=pathlib.Path, metavar="FILE", help="default: DIR/run.png")
    chosen = options.parse_args()
    results = chosen.dir / "results.h5"
    try:
        run = Run(results)
    except (OSError, KeyError) as trouble:
        sys.exit(f"{results}: not the results of a run ({trouble})")
    if len(run.columns["time"]) == 0:
        sys.exit(f"{results}: no history has been recorded yet")
    out = chosen.out or chosen.dir / "run.png"
    title = f"{chosen.dir.resolve().name}   ·   seed {run.provenance['seed']}"
    with plt.rc_context(STYLE):
        picture(run, title).savefig(out, dpi=150)
    print(out)


if __name__ == "__main__":
    main()
