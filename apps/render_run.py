#!/usr/bin/python3
"""Renders a run from its results: render_run.py DIR leaves in DIR/renders

    packing.png    the stones by size, the steel cut away
    forces.png     the force chains: a rod for each contact, as thick as its force is large
    fractures.png  the broken stones among the others
    slices.png     as a computed tomograph would see it
    gyration.gif   the last gyration, stones coloured by speed; needs 16 pictures of it, which
                   output.movie = true leaves (of a flow test: output.picture_interval)"""

import argparse
import pathlib
import sys

import matplotlib
import numpy as np
from PIL import Image

from plots import scene3d as vtk
from plots import slices
from plots.errors import InputError, exit_status_of
from plots.run import Run
from plots.style import STYLE, save

SIZE, MOVIE_SIZE = (1000, 900), (520, 468)
FEWEST_FRAMES = 16  # that make a movie of a gyration
MOVIE_SECONDS = 3


class Scenery:
    """The stones and the room they are in, at the end of a run."""

    def __init__(self, folder):
        self.folder = folder
        self.run = Run(folder)
        table = self.run.table("stones")
        if not table or "x" not in table:
            raise InputError(f"{folder}: expected a run that has recorded a picture, found none "
                             "yet; wait for it")
        self.place = np.stack([table["x"], table["y"], table["z"]], axis=1)
        if self.run.gyratory:
            radius = self.run.table("mould")["diameter"][0] / 2
            self.low = np.array([-radius, -radius, 0])
            self.high = np.array([radius, radius, self.run.table("head")["centre"][2]])
        else:
            self.low, self.high = np.zeros(3), self.run.table("box")["size"].copy()
            self.high[2] = max(self.place[:, 2] + table["radius"])
        self.middle = np.array([*(self.low + self.high)[:2] / 2, 0])
        self.radius = table["radius"]

    def stage(self, title, size=SIZE):
        return vtk.Stage(size, title, self.high[2], self.high[0] - self.low[0])

    def steel(self, opacity=1, picture=-1):
        """Head and mould, or the strip, cut in half; what stands far above the stones is left
        off."""
        things = []
        for name in ("head", "mould") if self.run.gyratory else ("strip",):
            path = vtk.pictures(self.folder, name)[picture][1]
            part = vtk.cut_steel(vtk.read(path), self.middle[1], 1.3 * self.high[2], opacity)
            part.AddPosition(*-self.middle)
            things.append(part)
        return things

    def centres(self, places=None):
        return (self.place if places is None else places) - self.middle


def packing(scenery):
    stage = scenery.stage("Stones by diameter")
    diameter = 2e3 * scenery.radius
    scale = vtk.colours(diameter.min(), diameter.max(), vtk.COOL[:1] + vtk.WARM)
    cloud = vtk.points(scenery.centres(), size=2 * scenery.radius, diameter=diameter)
    stage.add(vtk.spheres(cloud, "size", "diameter", scale), *scenery.steel())
    stage.explain(scale, "mm")
    return stage.image()


def forces(scenery):
    """Contacts that carry more than half the mean force; those with walls end at the wall."""
    between, walls = scenery.run.table("contacts"), scenery.run.table("wall_contacts")
    at_wall = np.stack([walls[axis] for axis in "xyz"], axis=1)
    begin = np.concatenate([scenery.place[between["first"].astype(int)],
                            scenery.place[walls["stone"].astype(int)]])
    end = np.concatenate([scenery.place[between["second"].astype(int)], at_wall])
    force = np.concatenate([between["normal_force"], walls["normal_force"]])
    if not np.any(force > 0):
        stage = scenery.stage("Force chains: nothing presses")
        stage.add(*scenery.steel(0.25))
        return stage.image()
    mean = force[force > 0].mean()
    strong = force > 0.5 * mean
    most = np.quantile(force[strong], 0.99)
    scale = vtk.colours(0, most, vtk.WARM)
    thick = 0.09 * np.median(scenery.radius) * np.sqrt(force[strong] / mean)
    stage = scenery.stage(f"Force chains: {strong.sum()} contacts above half the mean, "
                          f"{0.5 * mean:.2g} N")
    stage.add(vtk.rods(scenery.centres(begin[strong]), scenery.centres(end[strong]), thick,
                       force[strong], scale), *scenery.steel(0.25))
    stage.explain(scale, "N")
    return stage.image()


def fractures(scenery):
    broken = np.zeros(len(scenery.radius), bool)
    broken[scenery.run.table("fractures")["stone"].astype(int)] = True
    stage = scenery.stage(f"{broken.sum()} of {len(broken)} stones broke" if broken.any()
                          else f"None of {len(broken)} stones broke")
    for chosen, colour, opacity in ((~broken, (0.35, 0.4, 0.5), 0.15),
                                    (broken, (0.74, 0.1, 0.1), 1)):
        if chosen.any():
            cloud = vtk.points(scenery.centres()[chosen], size=2 * scenery.radius[chosen])
            stage.add(vtk.spheres(cloud, "size", colour=colour, opacity=opacity))
    stage.add(*scenery.steel(0.3))
    return stage.image()


def movie_frames(scenery):
    """Which pictures show the last gyration (of a flow test: all)."""
    times = [time for time, _ in vtk.pictures(scenery.folder, "stones")]
    if not scenery.run.gyratory:
        return list(range(len(times)))
    turn = scenery.run.gyration_at(np.array(times))
    return [k for k in range(len(times)) if turn[k] > max(0, turn[-1] - 1)]


def movie(scenery, out):
    """False where there are too few pictures."""
    frames = movie_frames(scenery)
    if len(frames) < FEWEST_FRAMES:
        return False
    series = vtk.pictures(scenery.folder, "stones")
    clouds = [vtk.read(series[k][1]) for k in frames]
    speeds = [1e3 * np.linalg.norm(vtk.array(cloud, "velocity [m/s]"), axis=1) for cloud in clouds]
    scale = vtk.colours(0, np.quantile(np.concatenate(speeds), 0.98), vtk.COOL[:1] + vtk.WARM)
    images = []
    for k, cloud, speed in zip(frames, clouds, speeds):
        stage = scenery.stage(f"Speed of the stones, {series[k][0]:.2f} s", MOVIE_SIZE)
        drawn = vtk.points(scenery.centres(vtk.vtk_to_numpy(cloud.GetPoints().GetData())),
                           size=vtk.array(cloud, "diameter [m]"), speed=speed)
        stage.add(vtk.spheres(drawn, "size", "speed", scale), *scenery.steel(picture=k))
        stage.explain(scale, "mm/s")
        images.append(Image.fromarray(stage.image()).quantize(128))
    images[0].save(out, save_all=True, append_images=images[1:], loop=0,
                   duration=max(40, int(1000 * MOVIE_SECONDS / len(images))), optimize=True)
    return True


def why_no_movie(scenery):
    """And what to set, for the next run of this scene."""
    scene = scenery.run.scene()
    if scenery.run.gyratory:
        of, advice = "the last gyration", "output.movie = true"
        length = 1 / scene["gyration"]["speed"]
    else:
        of, advice = "the test", ""
        length = scene["flow"]["displacement"] / scene["flow"]["speed"]
    interval = length / FEWEST_FRAMES
    advice += " or " * bool(advice) + f'output.picture_interval = "{interval:.3g} s"'
    if scene["output"]["history_interval"] > interval:
        advice += ", and output.history_interval no longer than that"
    return (f"no movie: expected {FEWEST_FRAMES} pictures of {of}, found "
            f"{len(movie_frames(scenery))}; run it again with {advice}")


def main():
    options = argparse.ArgumentParser(description=__doc__,
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dir", type=pathlib.Path, metavar="DIR", help="folder of a run")
    options.add_argument("--out", type=pathlib.Path, metavar="FOLDER", help="default: DIR/renders")
    chosen = options.parse_args()
    scenery = Scenery(chosen.dir)
    vtk.on_some_screen()
    out = chosen.out or chosen.dir / "renders"
    out.mkdir(parents=True, exist_ok=True)
    drawn = {draw.__name__: draw(scenery) for draw in (packing, forces, fractures)}
    moves = movie(scenery, out / "gyration.gif")
    for name, image in drawn.items():
        Image.fromarray(image).save(out / f"{name}.png")
        print(out / f"{name}.png")
    with matplotlib.rc_context(STYLE):
        save(slices.draw(scenery.run, (scenery.low, scenery.high)), out / "slices.png", dpi=110)
    print(out / "slices.png")
    if moves:
        print(out / "gyration.gif")
    else:
        print(why_no_movie(scenery), file=sys.stderr)


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
