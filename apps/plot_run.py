#!/usr/bin/python3
"""Draws runs from their results: plot_run.py DIR leaves in the run's folder

    run.png          the curves one looks at first
    plots/*.png,svg  every picture by itself
    report.html      all of them on one page that needs no other file

Of several folders the curves are laid over each other, in FIRST_DIR/compared/. With --live, run.png
is drawn again while the run goes on: results.h5 is replaced as a whole every few seconds, so that
whoever opens it reads a complete file."""

import argparse
import fcntl
import pathlib
import sys
import time

import matplotlib
import matplotlib.pyplot as plt

from plots import page
from plots.compaction import overview
from plots.run import Run
from plots.style import STYLE


def save(figure, out):
    """Replaces the picture as a whole, for viewers that watch it."""
    part = out.with_name(".part_" + out.name)  # the ending tells matplotlib the format
    figure.savefig(part, dpi=120 if out.suffix == ".png" else 200)
    part.replace(out)


def draw_overview(run, out):
    """False where there is nothing to be seen yet."""
    figure = overview(run)
    if figure is None:
        return False
    state = "" if run.summary else "   ·   not finished"
    figure.suptitle(f"{run.name}   ·   seed {run.provenance['seed']}{state}", x=0.01, ha="left",
                    fontsize=13)
    save(figure, out)
    plt.close(figure)
    return True


def draw_all(runs, out):
    """Pictures and page of one run, or of several laid over each other."""
    pictures = out / "plots"
    pictures.mkdir(parents=True, exist_ok=True)
    drawn = []
    for name, heading, figure, words in page.figures(runs):
        figure.draw_without_rendering()
        figure.set_layout_engine("none")  # once is enough
        for ending in ("png", "svg"):
            save(figure, pictures / f"{name}.{ending}")
        plt.close(figure)
        drawn.append((name, heading, words))
    report = out / "report.html"
    report.write_text(page.report(runs, pictures, drawn))
    return report


def goes_on(folder):
    """Whether a process holds the lock of the run."""
    try:
        with open(folder / "lock") as lock:
            fcntl.flock(lock, fcntl.LOCK_SH | fcntl.LOCK_NB)
    except FileNotFoundError:
        return False
    except BlockingIOError:
        return True
    return False


def watch(folder, out, interval):
    """Draws again whenever the run has recorded more, until it ends."""
    drawn = None
    while True:
        running = goes_on(folder)
        finished = (folder / "summary.json").exists()
        try:
            now = (folder / "results.h5").stat()
            # Empty: the very first one is being written.
            if now.st_size and now.st_mtime_ns != drawn and draw_overview(Run(folder), out):
                drawn = now.st_mtime_ns
                print(f"{time.strftime('%H:%M:%S')} {out}", flush=True)
        except FileNotFoundError:
            pass  # not yet
        if finished:
            return
        if not running:
            sys.exit(f"{folder}: expected a run that goes on or has finished, found neither; "
                     f"start it, or go on with it by --resume {folder}")
        time.sleep(interval)


def name_apart(runs):
    """By what differs in the paths of their folders."""
    paths = [list(run.folder.resolve().parts) for run in runs]
    for end in (0, -1):
        while all(len(path) > 1 and path[end] == paths[0][end] for path in paths):
            for path in paths:
                path.pop(end)
    for run, path in zip(runs, paths):
        run.name = "/".join(path)


def one_program(runs):
    if len({run.gyratory for run in runs}) > 1:
        sys.exit("expected runs of one program, found gyratory and flow_test; plot them apart")
    if len({run.name for run in runs}) < len(runs):
        name_apart(runs)


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dirs", type=pathlib.Path, metavar="DIR", nargs="+",
                         help="folder of a run")
    options.add_argument("--out", type=pathlib.Path, metavar="FOLDER",
                         help="where the pictures go, if not into the run's folder")
    options.add_argument("--live", type=float, metavar="SECONDS", nargs="?", const=5,
                         help="draw run.png again while the run goes on, looking every 5 s")
    chosen = options.parse_args()
    several = len(chosen.dirs) > 1
    if chosen.live and several:
        options.error(f"--live: expected one folder, found {len(chosen.dirs)}; "
                      "watch each by itself")
    if chosen.live and not chosen.dirs[0].is_dir():
        options.error(f"{chosen.dirs[0]}: expected the folder of a run, found none; "
                      "correct the path, or start the run first")
    out = chosen.out or (chosen.dirs[0] / "compared" if several else chosen.dirs[0])
    if chosen.out or several:
        out.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(STYLE):
        try:
            if chosen.live:
                return watch(chosen.dirs[0], out / "run.png", chosen.live)
            runs = [Run(folder) for folder in chosen.dirs]
        except (OSError, KeyError) as trouble:
            sys.exit(f"{', '.join(map(str, chosen.dirs))}: not the results of a run ({trouble})")
        one_program(runs)
        if not several and not draw_overview(runs[0], out / "run.png"):
            sys.exit(f"{runs[0].name}: nothing has been recorded yet")
        print(draw_all(runs, out))


if __name__ == "__main__":
    main()
