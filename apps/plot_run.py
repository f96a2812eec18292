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
from plots.errors import InputError, exit_status_of
from plots.folders import NEW_RUN, OTHER, RUN, expect, kind_of
from plots.run import Run
from plots.style import STYLE, save


def draw_overview(run, out):
    """False where there is nothing to be seen yet."""
    figure = overview(run)
    if figure is None:
        return False
    state = "" if run.summary else "   ·   not finished"
    figure.suptitle(f"{run.name}   ·   seed {run.provenance['seed']}{state}", x=0.01, ha="left",
                    fontsize=13)
    save(figure, out, dpi=120)
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
            save(figure, pictures / f"{name}.{ending}", dpi=120 if ending == "png" else 200)
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
            raise InputError(f"{folder}: expected a run that goes on or has finished, found "
                             f"neither; start it, or go on with it by --resume {folder}")
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


def runs_to_draw(folders):
    """Of one program, known apart by their names."""
    runs = [Run(folder) for folder in folders]
    for run in runs:
        if not run.began and not run.table("filling"):
            raise InputError(f"{run.folder}: expected a run that has recorded something, found "
                             "nothing yet; wait for it, or plot_run.py --live does so")
    if len({run.gyratory for run in runs}) > 1:
        raise InputError(f"{runs[0].folder}: expected runs of one program, found gyratory and "
                         "flow_test; plot them apart")
    if len({run.name for run in runs}) < len(runs):
        name_apart(runs)
    return runs


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
    live, several = chosen.live is not None, len(chosen.dirs) > 1
    if live and several:
        raise InputError(f"--live: expected one folder, found {len(chosen.dirs)}; "
                         "watch each by itself")
    if live and not chosen.live > 0:
        raise InputError(f"--live: expected seconds above 0, found {chosen.live:g}; write it like "
                         "--live 5")
    if live:
        if kind_of(chosen.dirs[0]) not in (NEW_RUN, OTHER):  # it may only begin
            expect(chosen.dirs[0], RUN)
    else:
        runs = runs_to_draw(chosen.dirs)
    out = chosen.out or (chosen.dirs[0] / "compared" if several else chosen.dirs[0])
    out.mkdir(parents=True, exist_ok=True)
    with matplotlib.rc_context(STYLE):
        if live:
            return watch(chosen.dirs[0], out / "run.png", chosen.live)
        if not several:
            draw_overview(runs[0], out / "run.png")
        print(draw_all(runs, out))


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
