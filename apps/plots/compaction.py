"""What a gyratory compaction and a compaction flow test are run for, over time."""
import numpy as np

from .style import GREY, INK, LINES, RED, colour_of, curves, figure, name_runs, whole_numbers

GYRATION, TIME = ("gyration", "gyrations"), ("time", "time")


def gyrating(run):
    return run.gyrating()


def draw_voids(axes, runs):
    """Air voids, and the share of the theoretical density that is left of them, over log N."""
    curves(axes, runs, GYRATION, [("air_voids", None)], "Compaction", "air voids", gyrating)
    axes.set_xscale("log")
    last = max(run.columns["gyration"][-1] for run in runs)
    axes.set_xlim(max(0.01, 2e-3 * last), 1.1 * last)
    axes.xaxis.set_major_formatter("{x:g}")
    gmm = axes.secondary_yaxis("right", functions=(lambda voids: 100 - voids, lambda g: 100 - g))
    gmm.set_ylabel("%Gmm")
    gmm.spines["right"].set_visible(True)


def draw_decrease(axes, runs):
    curves(axes, runs, GYRATION, [("air_voids_decrease", None)], "Decrease of air voids",
           "decrease", gyrating)


def draw_pressure(axes, runs, x=TIME):
    """What the ram imposes and what the mix answers."""
    for run in runs:
        if run.table("mould"):
            section = np.pi / 4 * run.table("mould")["diameter"][0]**2
            axes.plot(run.shown(x[0]), 1e-3 * run.columns["head_force"] / section, linewidth=0.8,
                      color=RED if len(runs) == 1 else colour_of(runs, run),
                      alpha=1 if len(runs) == 1 else 0.5,
                      label="mix on head, force / section" if len(runs) == 1 else None)
        axes.plot(run.shown(x[0]), run.shown("ram_pressure"), color=colour_of(runs, run),
                  label="imposed at the ram" if len(runs) == 1 else None)
    axes.set_title("Ram pressure" + (" and the mix's answer (faint)" if len(runs) > 1 else ""))
    axes.set_xlabel(runs[0].label(x[1], x[0]))
    axes.set_ylabel("pressure [kPa]")
    if len(runs) == 1:
        axes.legend()


def draw_angle(axes, runs):
    curves(axes, runs, GYRATION, [("commanded_angle", "commanded"), ("internal_angle", "internal")],
           "Angle", "angle", gyrating)


def draw_fractured(axes, runs, x):
    for run in runs:
        rows = run.gyrating() if x is GYRATION else slice(None)
        axes.step(run.shown(x[0])[rows], run.columns["fractured"][rows], where="post",
                  color=INK if len(runs) == 1 else colour_of(runs, run))
    axes.set_title("Fractured stones")
    axes.set_xlabel(runs[0].label(x[1], x[0]))
    axes.set_ylabel("stones [-]")
    most = max(1, max(run.columns["fractured"].max() for run in runs))
    axes.set_ylim(-0.05 * most, 1.1 * most)
    whole_numbers(axes.yaxis)


def draw_coordination(axes, runs, x):
    curves(axes, runs, x, [("coordination", None)], "Coordination", "contacts per stone",
           gyrating if x is GYRATION else None)


def centre_of_force(run):
    """Where the mix presses on the head, from the plate's middle [mm]: M = r x F."""
    rows = run.gyrating()
    force = run.columns["head_force"][rows]
    pressed = np.where(force > 0.05 * force.max(), force, np.nan)
    return (-1e3 * run.columns["head_moment_y"][rows] / pressed,
            1e3 * run.columns["head_moment_x"][rows] / pressed)


def draw_moment(axes, runs):
    moment = lambda run: np.hypot(run.columns["head_moment_x"],
                                  run.columns["head_moment_y"])[run.gyrating()]
    over_gyrations(axes, runs, moment, "Moment on the head", "moment [N m]")


def draw_eccentricity(axes, runs):
    over_gyrations(axes, runs, lambda run: np.hypot(*centre_of_force(run)),
                   "Eccentricity of the force, moment / force", "from the middle [mm]")


def over_gyrations(axes, runs, found, title, words):
    """What is found in a run, from zero."""
    for run in runs:
        axes.plot(run.shown("gyration")[run.gyrating()], found(run), color=colour_of(runs, run),
                  linewidth=0.8)
    axes.set_title(title)
    axes.set_xlabel("gyrations [-]")
    axes.set_ylabel(words)
    axes.set_ylim(bottom=0)


def draw_path_of_force(axes, runs):
    """The last gyration of the point at which the force acts, seen from above."""
    for run in runs:
        x, y = centre_of_force(run)
        turns = run.columns["gyration"][run.gyrating()]
        last = turns >= turns[-1] - 1
        axes.plot(x[last], y[last], color=colour_of(runs, run), linewidth=0.8)
    axes.set_title("Where the mix presses, last gyration from above")
    axes.set_xlabel("x [mm]")
    axes.set_ylabel("y [mm]")
    axes.axhline(0, color=GREY, linewidth=0.6)
    axes.axvline(0, color=GREY, linewidth=0.6)
    axes.set_aspect("equal", adjustable="datalim")


def compaction(runs):
    page = figure(10, 6.6)
    axes = page.subplots(2, 2)
    draw_voids(axes[0, 0], runs)
    draw_decrease(axes[0, 1], runs)
    curves(axes[1, 0], runs, GYRATION, [("height", None)], "Height of the specimen", "height",
           gyrating)
    draw_fractured(axes[1, 1], runs, GYRATION)
    name_runs(page, runs)
    return page


def head(runs):
    page = figure(10, 9.9)
    axes = page.subplots(3, 2)
    draw_pressure(axes[0, 0], runs)
    draw_angle(axes[0, 1], runs)
    draw_moment(axes[1, 0], runs)
    draw_eccentricity(axes[1, 1], runs)
    draw_path_of_force(axes[2, 0], runs)
    curves(axes[2, 1], runs, GYRATION, [("head_traction", "head"), ("mould_traction", "mould"),
                                        ("floor_traction", "floor")],
           "Mean pressure of the mix on the steel", "pressure", gyrating)
    axes[2, 1].set_ylim(bottom=0)
    name_runs(page, runs)
    return page


def relative_displacement(run):
    """Of the strip, over the height of the bed, as the paper shows it [-]."""
    height = run.summary.get("bed_height_m")
    if height is None:
        height = run.table("filling")["height"][-1]
    return run.columns["displacement"] / height


def flow(runs):
    """As figure 3 of Olsson, Jelagin, Partl."""
    page = figure(10, 3.6)
    axes = page.subplots(1, 2)
    for run in runs:
        x = relative_displacement(run)
        axes[0].plot(x, run.shown("pressure"), color=colour_of(runs, run), linewidth=1)
        axes[1].plot(x, run.shown("uplift"), color=colour_of(runs, run), linewidth=1)
    for panel, title, words in zip(axes, ("Pressure under the strip", "Uplift of the ten highest stones"),
                                   ("force / area [kPa]", "ten highest points [mm]")):
        panel.set_title(title)
        panel.set_xlabel("displacement / height of the bed [-]")
        panel.set_ylabel(words)
    axes[1].axhline(0, color=INK, linewidth=0.8)
    name_runs(page, runs)
    return page


def filling(runs):
    """How the bed came to rest and was pressed until the history begins."""
    runs = [run for run in runs if run.table("filling")]
    if not runs:
        return None
    page = figure(10, 3.4)
    axes = page.subplots(1, 2)
    for run in runs:
        table, colour = run.table("filling"), colour_of(runs, run)
        axes[0].plot(table["time"], 1e3 * table["height"], color=colour)
        axes[1].semilogy(table["time"], np.maximum(table["kinetic_energy"], 1e-12), color=colour)
        pressed = np.flatnonzero(table["pressure"] > 0)
        for panel in axes if len(pressed) else ():
            panel.axvline(table["time"][pressed[0]], color=colour, linestyle=LINES[1],
                          linewidth=0.8)
    axes[0].set_title("Height of the bed, ten highest stones")
    axes[0].set_ylabel("height [mm]")
    dashed = " (dashed: the head comes down)" if runs[0].gyratory else ""
    axes[1].set_title("Kinetic energy" + dashed)
    axes[1].set_ylabel("energy [J]")
    for panel in axes:
        panel.set_xlabel("time from the beginning of the run [s]")
    name_runs(page, runs)
    return page


def overview(run):
    """One page of the most watched curves, for a run that may still go on."""
    runs = [run]
    if not run.began:
        return filling(runs)
    if not run.gyratory:
        page = figure(7, 9)
        axes = page.subplots(3, 1)
        x = ("displacement", "strip displacement")
        curves(axes[0], runs, x, [("pressure", None)], "Pressure under the strip", "pressure")
        curves(axes[1], runs, x, [("uplift", None)], "Uplift of the ten highest stones", "uplift")
        axes[1].axhline(0, color=INK, linewidth=0.8)
        draw_fractured(axes[2], runs, x)
        return page
    page = figure(10, 10)
    axes = page.subplots(3, 2)
    draw_voids(axes[0, 0], runs)
    draw_decrease(axes[0, 1], runs)
    draw_pressure(axes[1, 0], runs)
    draw_angle(axes[1, 1], runs)
    draw_fractured(axes[2, 0], runs, GYRATION)
    draw_coordination(axes[2, 1], runs, GYRATION)
    return page
