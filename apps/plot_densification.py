#!/usr/bin/python3
"""Draws how mixes densify: plot_densification.py DIR [--from 5] leaves DIR/densification.png and .svg,
the density of a run of gyratory compaction, or of every finished run of a study, in per cent of its
greatest (%Gmm = 100 less the air voids) over the logarithm of the gyrations, and prints the slope per
decade of gyrations from the given one on, of a study by setting with the standard error over its seeds."""
import argparse
import itertools
import pathlib
import sys

import h5py
import matplotlib.pyplot as plt
import numpy

from plots import slope
from plots.style import GREY, OF_CURVES, STYLE

FIRST = 0.5  # gyrations: before, the head still settles


class Run:
    def __init__(self, path):
        self.folder = path.parent
        with h5py.File(path) as file:
            if "history/gyration" not in file:
                sys.exit(f"{self.folder}: expected a run of gyratory, found one without gyrations; "
                         "plot_run.py draws it")
            gyration = file["history/gyration"][:]
            counted = gyration > FIRST
            self.gyration = gyration[counted]
            self.density = 100 * (1 - file["history/air_voids"][:][counted])
            self.last = gyration.max(initial=0)

    def slope(self, first):
        if self.last <= FIRST:
            sys.exit(f"{self.folder}: expected more than {FIRST:g} gyrations, found "
                     f"{self.last:.3g}; draw it when it has more")
        if not FIRST <= first < self.last:
            sys.exit(f"{self.folder}: expected --from at least {FIRST:g} and below the "
                     f"{self.last:.3g} gyrations of this run, found {first:g}; give --from "
                     f"{max(FIRST, self.last / 2):.3g}")
        return slope.per_decade(self.gyration, self.density, first)


def settings_of(folder):
    if (folder / "results.h5").exists():
        return {folder.resolve().name: [Run(folder / "results.h5")]}
    found, current = {}, None
    if (folder / "study.h5").exists():
        with h5py.File(folder / "study.h5") as file:
            current = set(file.get("settings", ()))
    for path in sorted(folder.glob("runs/*/seed_*/results.h5")):
        word = path.parent.parent.name
        if not (path.parent / "summary.json").exists():
            print(f"{path.parent}: left out, not at its end", file=sys.stderr)
        elif current is not None and word not in current:
            print(f"{path.parent}: left out, no setting of study.h5", file=sys.stderr)
        else:
            found.setdefault(word.replace("_", " "), []).append(Run(path))
    return found


def draw(settings, first):
    figure, axes = plt.subplots(figsize=(8, 5))
    looks = itertools.product(("-", "--", ":", "-."), OF_CURVES)
    for (dashes, color), (name, runs) in zip(itertools.cycle(looks), settings.items()):
        for k, run in enumerate(runs):
            axes.plot(run.gyration, run.density, color=color, linestyle=dashes, linewidth=1.2,
                      label=name if k == 0 else None)
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
    parser.add_argument("--from", dest="first", type=float, default=5, help="gyrations")
    options = parser.parse_args()
    settings = settings_of(options.folder)
    if not settings:
        sys.exit(f"{options.folder}: expected results.h5 of a run, or finished runs/SETTING/seed_N of trade")
    slopes_of = {name: [run.slope(options.first) for run in runs]
                 for name, runs in settings.items()}
    with plt.rc_context(STYLE):
        figure = draw(settings, options.first)
        for ending in ("png", "svg"):
            figure.savefig(options.folder / f"densification.{ending}", dpi=110)
    print(f"| setting | runs | %Gmm per decade from gyration {options.first:g} | +- |")
    print("|---|---:|---:|---:|")
    for name, slopes in slopes_of.items():
        error = numpy.std(slopes, ddof=1) / len(slopes) ** 0.5 if len(slopes) > 1 else numpy.nan
        print(f"| {name} | {len(slopes)} | {numpy.mean(slopes):.2f} | {error:.2f} |")
    print(options.folder / "densification.png", file=sys.stderr)


if __name__ == "__main__":
    main()
