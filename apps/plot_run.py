#!/usr/bin/python3
"""Draws a run at a glance: `plot_run.py DIR` makes DIR/run.png from DIR/results.h5.

Several folders give DIR/compared.png with their curves laid over each other; --report makes one
page of it all that needs no other file. With --live the picture is drawn again while the run goes
on: results.h5 is replaced as a whole every few seconds, so that whoever opens it reads a complete
file."""

import argparse
import copy
import html
import io
import json
import pathlib
import sys
import time

import h5py
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

INK, BLUE, RED = "#222222", "#2166ac", "#b2182b"

# Kinds of energy in the order they are stacked: column, words, colour.
ENERGIES = [("energy_kinetic", "kinetic", "#000000"),
            ("energy_stone_elastic", "stone, elastic", "#053061"),
            ("energy_binder_stored", "binder, stored", "#2166ac"),
            ("energy_binder_dissipated", "binder, dissipated", "#d6604d"),
            ("energy_film_area_change", "film, area changed", "#f4a582"),
            ("energy_friction", "friction", "#b2182b"),
            ("energy_stone_area_change", "stone contact, area changed", "#fddbc7"),
            ("energy_damping", "damping", "#bababa"),
            ("energy_bond_breaking", "bonds broken", "#762a83"),
            ("energy_fracture", "fracture", "#1b7837")]

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


def draw_energies(figure, run):
    """Where the work went since the history began; what gave energy back lies below zero."""
    kinds, residual = figure.subplots(2, 1, sharex=True, height_ratios=[3, 1])
    time, above, below = run.shown("time"), 0.0, 0.0
    for column, legend, colour in ENERGIES:
        gained = run.columns[column] - run.columns[column][0]
        if not np.any(gained):
            continue
        top, bottom = above + np.maximum(gained, 0), below + np.minimum(gained, 0)
        kinds.fill_between(time, above, top, color=colour, linewidth=0, label=legend)
        kinds.fill_between(time, below, bottom, color=colour, linewidth=0)
        above, below = top, bottom
    work = run.columns["energy_work_of_walls"] + run.columns["energy_work_of_gravity"]
    kinds.plot(time, work - work[0], color=INK, label="work of walls and weight")
    kinds.set_title("Where the work goes")
    kinds.set_ylabel("energy [J]")
    kinds.legend(loc="upper left", bbox_to_anchor=(1, 1))
    residual.plot(time, 100 * run.columns["energy_residual_share"], color=INK)
    residual.set_title("Not accounted for")
    residual.set_xlabel(run.label("time", "time"))
    residual.set_ylabel("of the work [%]")


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
    booked = "energy_residual" in run.columns
    width, height = (10, 10) if gyratory else (7, 9)
    figure = plt.figure(figsize=(width, height + 4 * booked), layout="constrained")
    figure.suptitle(title, x=0.01, ha="left", fontsize=13)
    upper = figure
    if booked:
        upper, lower = figure.subfigures(2, 1, height_ratios=[height, 4])
        draw_energies(lower, run)
    (draw_gyratory if gyratory else draw_flow_test)(upper, run)
    return figure


def read(folder):
    run = Run(folder / "results.h5")
    if len(run.columns["time"]) == 0:
        raise EOFError("no history has been recorded yet; a gyratory run records once it gyrates")
    return run


def save(figure, out):
    """Replaces the picture as a whole, for viewers that watch it."""
    part = out.with_name(".part_" + out.name)  # the ending tells matplotlib the format
    figure.savefig(part, dpi=150)
    plt.close(figure)
    part.replace(out)


def draw_one(folder, out):
    run = read(folder)
    title = f"{folder.resolve().name}   ·   seed {run.provenance['seed']}"
    with plt.rc_context(STYLE):
        save(picture(run, title), out)


# What is compared of several runs: column, title, quantity; over gyrations or over displacement.
COMPARED = {
    "gyration": [("air_voids", "Compaction", "air voids"),
                 ("air_voids_decrease", "Decrease of air voids", "decrease"),
                 ("height", "Height", "height"), ("internal_angle", "Internal angle", "angle"),
                 ("fractured", "Fractured stones", "stones"),
                 ("coordination", "Coordination", "contacts per stone")],
    "displacement": [("pressure", "Pressure under the strip", "pressure"),
                     ("uplift", "Uplift beside the strip", "uplift"),
                     ("fractured", "Fractured stones", "stones"),
                     ("coordination", "Coordination", "contacts per stone")],
}


def compare(folders):
    """A figure with the curves of several runs of the same program laid over each other."""
    runs = {folder.resolve().name: read(folder) for folder in folders}
    kinds = {"gyration" if "gyration" in run.columns else "displacement" for run in runs.values()}
    if len(kinds) > 1:
        sys.exit("expected runs of one program, found both; plot them apart")
    x = kinds.pop()
    figure = plt.figure(figsize=(10, 3.3 * len(COMPARED[x]) / 2), layout="constrained")
    panels = figure.subplots(len(COMPARED[x]) // 2, 2)
    for axes, (column, title, quantity) in zip(panels.flat, COMPARED[x]):
        for number, (name, run) in enumerate(runs.items()):
            shown = run.since_first_gyration() if x == "gyration" else run
            axes.plot(shown.shown(x), shown.shown(column), color=f"C{number}", label=name)
        axes.set_title(title)
        axes.set_xlabel(run.label(x, x))
        axes.set_ylabel(run.label(quantity, column))
        if x == "gyration" and column.startswith("air_voids"):
            axes.set_xscale("log")
            axes.set_xlim(left=max(0.1, 0.01 * shown.columns[x][-1]))
    panels[0, 0].legend()
    return figure


def embedded(figure):
    """A figure as text for a page that needs no other file."""
    image = io.BytesIO()
    figure.savefig(image, format="svg")
    plt.close(figure)
    text = image.getvalue().decode()
    return text[text.index("<svg"):]


PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title><style>
body {{ font: 15px/1.45 sans-serif; color: #222; max-width: 1050px; margin: 2em auto;
       padding: 0 1em }}
svg {{ max-width: 100%; height: auto }} td, th {{ text-align: left; padding: .15em 1.2em .15em 0 }}
pre {{ background: #f5f5f5; padding: 1em; overflow-x: auto }} h2 {{ margin-top: 1.8em }}
</style></head><body><h1>{title}</h1>
{body}
</body></html>
"""


def table(rows, head):
    lines = ["<tr>" + "".join(f"<th>{html.escape(word)}</th>" for word in head) + "</tr>"]
    for row in rows:
        cells = "".join(f"<td>{html.escape(str(word))}</td>" for word in row)
        lines.append(f"<tr>{cells}</tr>")
    return "<table>" + "\n".join(lines) + "</table>"


def report(folders):
    """One page with the pictures, the summaries and the scenes of the runs."""
    body = []
    summaries = []
    with plt.rc_context(STYLE):
        if len(folders) > 1:
            body.append("<h2>Compared</h2>" + embedded(compare(folders)))
        for folder in folders:
            run = read(folder)
            body.append(f"<h2>{html.escape(folder.resolve().name)}</h2>")
            body.append(embedded(picture(run, "")))
            origin = [(key, run.provenance[key]) for key in
                      ("program", "version", "compiler", "flags", "seed", "command_line")]
            body.append("<h3>Where it comes from</h3>" + table(origin, ("what", "value")))
            stored = folder / "scene.toml"
            scene = stored.read_text() if stored.exists() else run.provenance["scene"]
            body.append(f"<h3>Scene</h3><pre>{html.escape(scene)}</pre>")
            summary = folder / "summary.json"
            summaries.append(json.loads(summary.read_text()) if summary.exists() else {})
    keys = dict.fromkeys(key for summary in summaries for key in summary)
    show = lambda value: f"{value:.6g}" if isinstance(value, float) else value
    rows = [[key] + [show(summary.get(key, "")) for summary in summaries] for key in keys]
    names = [folder.resolve().name for folder in folders]
    body.insert(0, "<h2>Summary</h2>" + table(rows, ["finding"] + names))
    return PAGE.format(title=html.escape(", ".join(names)), body="\n".join(body))


def watch(folder, out, interval):
    """Draws again whenever the run has recorded more, until it has left its summary."""
    drawn = None
    while True:
        finished = (folder / "summary.json").exists()
        try:
            now = (folder / "results.h5").stat().st_mtime_ns
            if now != drawn:
                draw_one(folder, out)
                drawn = now
                print(f"{time.strftime('%H:%M:%S')} {out}", flush=True)
        except (EOFError, FileNotFoundError):
            pass  # not yet
        if finished:
            return
        time.sleep(interval)


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("dirs", type=pathlib.Path, metavar="DIR", nargs="+",
                         help="folder of a run; of several the curves are laid over each other")
    options.add_argument("--out", type=pathlib.Path, metavar="FILE",
                         help="default: run.png, compared.png or report.html in the first DIR")
    options.add_argument("--live", type=float, metavar="SECONDS", nargs="?", const=5,
                         help="draw again while the run goes on, looking every 5 s")
    options.add_argument("--report", action="store_true",
                         help="one page, report.html, with pictures, summaries and scenes")
    chosen = options.parse_args()
    first = chosen.dirs[0]
    several = len(chosen.dirs) > 1
    name = "report.html" if chosen.report else "compared.png" if several else "run.png"
    out = chosen.out or first / name
    try:
        if chosen.report:
            out.write_text(report(chosen.dirs))
        elif several:
            with plt.rc_context(STYLE):
                save(compare(chosen.dirs), out)
        elif chosen.live:
            return watch(first, out, chosen.live)
        else:
            draw_one(first, out)
    except (OSError, KeyError) as trouble:
        sys.exit(f"{', '.join(map(str, chosen.dirs))}: not the results of a run ({trouble})")
    except EOFError as trouble:
        sys.exit(f"{', '.join(map(str, chosen.dirs))}: {trouble}")
    print(out)


if __name__ == "__main__":
    main()
