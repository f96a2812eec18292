"""Where the work of a run goes, as its energy ledger says."""
import numpy as np

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
    axes.set_ylabel("energy [J]")
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))


def energy(runs):
    runs = [run for run in runs if "energy_residual" in run.columns]
    if not runs:
        return None
    page = figure(10, 4.2 * len(runs) + 1.6)
    axes = page.subplots(len(runs) + 1, 1, sharex=len(runs) == 1,
                         height_ratios=[3] * len(runs) + [1.2])
    for panel, run in zip(axes, runs):
        draw_kinds(panel, run)
        panel.set_title("Where the work goes" + (f": {run.name}" if len(runs) > 1 else ""))
    for run in runs:
        whole = np.max(np.abs(work_done(run)))
        axes[-1].plot(run.shown("time"), 100 * run.columns["energy_residual"] / whole,
                      color=colour_of(runs, run))
    axes[-1].set_title("Not accounted for")
    axes[-1].set_xlabel("time [s]")
    axes[-1].set_ylabel("of the whole work [%]")
    name_runs(page, runs)
    return page
