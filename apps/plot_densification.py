#!/usr/bin/python3
"""Draws how mixes densify: plot_densification.py DIR [--from 8] leaves DIR/densification.png and .svg,
the density of a run of gyratory compaction, or of every finished run of a study, in per cent of its
greatest (%Gmm = 100 less the air voids) over the logarithm of the gyrations, and prints the slope per
decade of gyrations from the given one and from 0.5 on, of a study by setting with the standard error over
its seeds, and the air voids before the gyrations and at the end."""
import argparse
import itertools
import pathlib
import sys

import matplotlib.pyplot as plt
import numpy as np

from plots import slope
from plots.errors import InputError, exit_status_of
from plots.folders import RUN, STUDY, expect
from plots.run import Run
from plots.study import runs_by_setting
from plots.style import GREY, LINES, OF_CURVES, STYLE, save

FIRST = 0.5  # gyrations: before, the head still settles


def density(run):
    """In per cent of the greatest, %Gmm."""
    return 100 * (1 - run.columns["air_voids"])


def slope_of(run, first):
    if not run.gyratory:
        raise InputError(f"{run.folder}: expected a run of gyratory, found one without gyrations; "
                         "plot_run.py draws it")
    last = run.columns["gyration"].max(initial=0)
    if last <= FIRST:
        raise InputError(f"{run.folder}: expected more than {FIRST:g} gyrations, found {last:.3g}; "
                         "draw it when it has more")
    if not FIRST <= first < last:
        raise InputError(f"{run.folder}: expected --from at least {FIRST:g} and below the "
                         f"{last:.3g} gyrations of this run, found {first:g}; give --from "
                         f"{max(FIRST, last / 2):.3g}")
    return slope.per_decade(run.columns["gyration"], density(run), first)


def voids_before(run):
    """The last before it gyrates, in per cent."""
    gyration = run.columns["gyration"]
    return 100 * run.columns["air_voids"][max(np.searchsorted(gyration, 0, side="right") - 1, 0)]


def table(settings, firsts):
    headings = ["setting", "runs"]
    for first in firsts:
        headings += [f"%Gmm per decade from gyration {first:g}", "+-"]
    headings += ["air voids before [%]", "at the end [%]"]
    yield headings
    yield ["---"] + ["---:"] * (len(headings) - 1)
    for name, runs in settings.items():
        row = [name, str(len(runs))]
        for first in firsts:
            slopes = [slope_of(run, first) for run in runs]
            error = np.std(slopes, ddof=1) / len(slopes) ** 0.5 if len(slopes) > 1 else np.nan
            row += [f"{np.mean(slopes):.2f}", f"{error:.2f}"]
        yield row + [f"{np.mean([voids_before(run) for run in runs]):.1f}",
                     f"{np.mean([100 - density(run)[-1] for run in runs]):.1f}"]


def settings_of(folder):
    if expect(folder, RUN, STUDY) == RUN:
        return {folder.resolve().name: [Run(folder)]}
    settings = {word.replace("_", " "): [Run(path) for path in paths]
                for word, paths in runs_by_setting(folder).items()}
    if not settings:
        raise InputError(f"{folder}: expected runs of a study that came to their end, found none; "
                         f"go on by trade STUDY.toml --out {folder}")
    return settings


def draw(settings, first):
    figure, axes = plt.subplots(figsize=(8, 5))
    looks = itertools.product(LINES, OF_CURVES)
    for (dashes, color), (name, runs) in zip(itertools.cycle(looks), settings.items()):
        for k, run in enumerate(runs):
            gyration = run.columns["gyration"]
            shown = gyration > FIRST
            axes.plot(gyration[shown], density(run)[shown], color=color, linestyle=dashes,
                      linewidth=1.2, label=name if k == 0 else None)
    axes.axvline(first, color=GREY, linewidth=0.6, linestyle=":")
    axes.set(xscale="log", xlabel="gyrations", ylabel="density [% of Gmm]")
    numbers = [n for n in (0.5, 1, 2, 5, 10, 20, 50, 100, 200, 500) if n <= axes.get_xlim()[1]]
    axes.set_xticks(numbers, [f"{n:g}" for n in numbers])
    axes.minorticks_off()
    axes.legend()
    return figure


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path, help="of a run, or of trade --out")
    parser.add_argument("--from", dest="first", type=float, default=FIRST,
                        help="gyrations")
    options = parser.parse_args()
    settings = settings_of(options.folder)
    rows = list(table(settings, dict.fromkeys((options.first, FIRST))))
    with plt.rc_context(STYLE):
        figure = draw(settings, options.first)
        for ending in ("png", "svg"):
            save(figure, options.folder / f"densification.{ending}", dpi=110)
    for row in rows:
        print("| " + " | ".join(row) + " |")
    print(options.folder / "densification.png", file=sys.stderr)


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
