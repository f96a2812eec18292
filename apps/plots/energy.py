"""Where the work of a run goes, as its energy ledger says."""
import numpy as np
from matplotlib.colors import to_rgb

from .style import INK, colour_of, figure, name_runs

# Kinds of energy in the order they are stacked: column, words, colour.
KINDS = [("energy_kinetic", "kinetic", "#000000"),
         ("energy_stone_elastic", "stone, elastic", "#053061"),
         ("energy_binder_stored", "binder, stored", "#2166ac"),
         ("energy_binder_dissipated", "binder, dissipated", "#d6604d"),
         ("energy_film_area_change", "film, area changed", "#f4a582"),
         ("energy_friction", "friction", "#b2182b"),
         ("energy_stone_area_change", "stone contact, area changed", "#fddbc7"),
         ("energy_damping", "damping", "#bababa"),
         ("energy_bond_breaking", "bonds broken", "#762a83"),
         ("energy_fracture", "fracture", "#1b7837")]


def work_done(run):
    work = run.columns["energy_work_of_walls"] + run.columns["energy_work_of_gravity"]
    return work - work[0]


def draw_kinds(axes, run):
    """Since the history began; what gave energy back lies below zero."""
    time, above, below = run.shown("time"), 0.0, 0.0
    for column, legend, colour in KINDS:
        gained = run.columns[column] - run.columns[column][0]
        if not np.any(gained):
            continue
        top, bottom = above + np.maximum(gained, 0), below + np.minimum(gained, 0)
        axes.fill_between(time, above, top, color=colour, linewidth=0, label=legend)
        axes.fill_between(time, below, bottom, color=colour, linewidth=0)
        above, below = top, bottom
    axes.plot(time, work_done(run), color=INK, label="work of walls and weight")
    axes.set_xlabel("time [s]")
    axes.set_ylabel("energy [J]")
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))


def stages(run):
    """Name, first and last row of the history."""
    last = len(run.columns["time"]) - 1
    if not run.gyratory:
        return [("strip goes down", 0, last)]
    gyrates = run.gyrating().start
    ramp = run.scene()["gyration"]["ramp"] / run.scene()["numerics"]["time_compression"]
    risen = min(int(np.searchsorted(run.columns["time"], ramp)), gyrates)
    found = [("pressure rises", 0, risen), ("dwells", risen, gyrates), ("gyrates", gyrates, last)]
    return [(name, row, end) for name, row, end in found if row < end <= last]


def draw_shares(axes, run):
    """Of what each stage cost, in per cent; what gave energy back is left out."""
    found = stages(run)
    if not found:  # only the first row is there
        return axes.axis("off")
    names, rows, ends = zip(*found)
    gains = [np.maximum(run.columns[column][list(ends)] - run.columns[column][list(rows)], 0)
             for column, _, _ in KINDS]
    left = np.zeros(len(names))
    for (_, _, colour), gained in zip(KINDS, gains):
        share = 100 * gained / np.maximum(np.sum(gains, axis=0), 1e-300)
        bars = axes.barh(names, share, left=left, color=colour)
        dark = np.mean(to_rgb(colour)) < 0.5
        axes.bar_label(bars, [f"{part:.0f}" if part >= 2 else "" for part in share],
                       label_type="center", fontsize=8, color="white" if dark else INK)
        left += share
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_xlabel("of what the stage cost [%]")


def energy(runs):
    runs = [run for run in runs if "energy_residual" in run.columns]
    if not runs:
        return None
    page = figure(10, 5.4 * len(runs) + 1.6)
    axes = page.subplots(2 * len(runs) + 1, 1, height_ratios=[3, 0.9] * len(runs) + [1.2])
    for kinds, shares, run in zip(axes[0::2], axes[1::2], runs):
        draw_kinds(kinds, run)
        kinds.set_title("Where the work goes" + (f": {run.name}" if len(runs) > 1 else ""))
        draw_shares(shares, run)
    for run in runs:
        whole = np.max(np.abs(work_done(run)))
        axes[-1].plot(run.shown("time"), 100 * run.columns["energy_residual"] / whole,
                      color=colour_of(runs, run))
    axes[-1].set_title("Not accounted for")
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_ylabel("of the whole work [%]")
    name_runs(page, runs)
    return page
