#!/usr/bin/python3
"""Draws a study: plot_trade.py DIR leaves DIR/trade.png and .svg. On the left the worst error of
each setting against its time, where it is beyond the noise of the seeds, hollow below all others where
none is, and the front of those that nothing beats in both and of which no run stopped. On the right
the errors by quantity."""
import argparse
import pathlib
import sys

import h5py
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from plots import study
from plots.errors import InputError, exit_status_of
from plots.style import BLUE, GREY, INK, RED, STYLE, save


class Setting:
    def __init__(self, name, group, runs):
        counted = len(group["seeds"])  # runs that came to their end
        self.whole = counted == runs
        self.name = name.replace("_", " ")
        if not self.whole:
            self.name += f" ({counted} of {runs} runs)"
        self.seconds = np.mean(group["seconds"][:])
        known = {q: g for q, g in group.items() if isinstance(g, h5py.Group)}
        self.error = {q.replace("_", " "): g["error"][0] for q, g in known.items()}
        self.noise = {q.replace("_", " "): g["noise"][0] for q, g in known.items()}
        beyond = [e for q, e in self.error.items() if e > self.noise[q]]
        self.worst = max(beyond, default=0)  # 0: none that the seeds show


def front(settings):
    """Those whole ones that no other is both faster and better than, from fast to slow."""
    best, kept = np.inf, []
    for setting in sorted(settings, key=lambda s: s.seconds):
        if setting.whole and setting.worst < best:
            best = setting.worst
            kept.append(setting)
    return kept


def heights(settings):
    """Where each stands [%], those that show no error at a third of the least that is shown."""
    least = min((s.worst for s in settings if s.worst), default=0.03)
    return {s.name: 100 * (s.worst or least / 3) for s in settings}


def name_points(axes, settings):
    """Names beside the points, higher up on a thread where another name is in the way."""
    renderer = axes.figure.canvas.get_renderer()
    height = heights(settings)
    points = axes.transData.transform([(s.seconds, height[s.name]) for s in settings])
    taken = [Bbox([point - 4, point + 4]) for point in points]

    def box_of(name):
        name.update_positions(renderer)
        return Text.get_window_extent(name, renderer)

    for s in sorted(settings, key=lambda s: (s.worst, s.seconds)):
        name = axes.annotate(s.name, (s.seconds, height[s.name]), xytext=(6, 3),
                             textcoords="offset points", fontsize=8, color=INK,
                             arrowprops={"arrowstyle": "-", "color": GREY, "linewidth": 0.5})
        while any(box_of(name).overlaps(other) for other in taken):
            name.xyann = (name.xyann[0] + 1, name.xyann[1] + 4)
        taken.append(box_of(name))


def draw_front(axes, settings):
    height = heights(settings)
    for s in settings:
        axes.plot(s.seconds, height[s.name], "o", color=RED if s.worst else BLUE,
                  fillstyle="full" if s.worst else "none")
    line = front(settings)
    axes.step([s.seconds for s in line], [height[s.name] for s in line], where="post", color=GREY,
              linewidth=1, zorder=0)
    if any(not s.worst for s in settings):
        axes.axhline(1.7 * min(height.values()), color=GREY, linewidth=0.6, linestyle=":")
        axes.text(0.01, 1.7 * min(height.values()), "below: none beyond the noise", fontsize=8,
                  color=GREY, va="bottom", transform=axes.get_yaxis_transform())
    axes.set(xscale="log", yscale="log", xlabel="processor time [s]",
             ylabel="worst error beyond noise [%]", title="What time buys")
    axes.margins(x=0.25)
    axes.set_xlim(right=2.5 * axes.get_xlim()[1])


def draw_errors(axes, settings):
    quantities = list(dict.fromkeys(q for s in settings for q in s.error))
    share = np.array([[s.error.get(q, np.nan) / max(s.noise.get(q, 0), 1e-12)
                          for q in quantities] for s in settings])
    axes.imshow(np.clip(share, 0, 3), cmap="Reds", vmin=0, vmax=3, aspect="auto")
    for row, s in enumerate(settings):
        for column, q in enumerate(quantities):
            if q in s.error:
                axes.text(column, row, f"{100 * s.error[q]:.1f}", ha="center", va="center",
                          fontsize=8, color="white" if share[row, column] > 2 else INK,
                          fontweight="bold" if share[row, column] > 1 else "normal")
    axes.set_xticks(range(len(quantities)), quantities, rotation=30, ha="right", fontsize=8)
    axes.set_yticks(range(len(settings)), [s.name for s in settings], fontsize=8)
    axes.grid(False)
    axes.set_title("Errors [%], red by how far they are beyond the noise")


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="of trade --out")
    folder = parser.parse_args().folder
    with study.results(folder) as file:
        runs = len(file["study/seeds"])
        settings = [Setting(name, group, runs) for name, group in file.get("settings", {}).items()]
    settings.sort(key=lambda s: s.seconds)
    judged = [s for s in settings if s.error]
    if not judged:
        raise InputError(f"{folder}: expected a setting with two seeds that the reference has "
                         "finished too, found none; add seeds to the study and run trade again")
    study.runs_by_setting(folder)  # says which are left out
    for s in settings:
        if s not in judged:
            print(f"{s.name}: left out on the left, no quantity of it is judged", file=sys.stderr)
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(1, 2, figsize=(14, 0.25 * len(settings) + 4.5),
                                             width_ratios=(2, 3))
        draw_front(left, judged)
        draw_errors(right, settings)
        figure.draw_without_rendering()  # lays out, so that names can be measured
        figure.set_layout_engine("none")
        name_points(left, judged)
        for ending in ("png", "svg"):
            save(figure, folder / f"trade.{ending}", dpi=110)
    print(folder / "trade.png")


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
