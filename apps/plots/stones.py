"""The stones at the end of a run: sizes, neighbours, forces, fractures, the air between them."""
import numpy as np

from .style import GREY, INK, OF_CURVES, colour_of, figure, name_runs, whole_numbers


def with_bed(runs):
    """The runs that have left their stones."""
    return [run for run in runs if run.table("stones") and "x" in run.table("stones")]


def size_classes(runs):
    """The sieves between which the stones of all runs lie [mm]."""
    sieve = 1e3 * np.unique(np.concatenate([run.sieves()[0] for run in runs]))
    diameter = 2e3 * np.concatenate([run.table("stones")["radius"] for run in runs])
    low = max(0, np.searchsorted(sieve, diameter.min(), side="right") - 1)
    high = min(len(sieve), np.searchsorted(sieve, diameter.max(), side="left") + 1)
    return sieve[low:high]


def broken_diameters(run):
    return 2e3 * run.table("stones")["radius"][run.table("fractures")["stone"].astype(int)]


def draw_fractures_by_size(axes, runs):
    classes = size_classes(runs)
    width = 0.8 / len(runs)
    for k, run in enumerate(runs):
        broken, _ = np.histogram(broken_diameters(run), classes)
        all_stones, _ = np.histogram(2e3 * run.table("stones")["radius"], classes)
        place = np.arange(len(broken)) + (k - (len(runs) - 1) / 2) * width
        bars = axes.bar(place, broken, width, color=colour_of(runs, run))
        if len(runs) == 1:
            axes.bar_label(bars, [f"of {count}" for count in all_stones], fontsize=8, color=INK)
    axes.set_xticks(range(len(classes) - 1),
                    [f"{a:g}–{b:g}" for a, b in zip(classes, classes[1:])])
    axes.grid(axis="x", visible=False)
    axes.set_title("Fractures by size")
    axes.set_xlabel("between sieves [mm]")
    axes.set_ylabel("broken stones [-]")
    axes.set_ylim(0, 1.15 * max(1, axes.get_ylim()[1]))
    whole_numbers(axes.yaxis)


def draw_fractures_over_time(axes, runs):
    """Cumulated; of a run alone apart by size."""
    classes = size_classes(runs)
    for run in runs:
        table = run.table("fractures")
        at, end = table["time"], run.columns["time"][-1]
        groups = [(None, np.ones(len(at), bool))]
        if len(runs) == 1:
            sizes = np.digitize(broken_diameters(run), classes) - 1
            groups = [(f"{classes[c]:g}–{classes[c + 1]:g} mm", sizes == c)
                      for c in range(len(classes) - 1) if np.any(sizes == c)]
        for k, (legend, chosen) in enumerate(groups):
            steps = np.sort(at[chosen])
            axes.step([min(0, *at, 0), *steps, end], [*range(len(steps) + 1), len(steps)],
                      where="post", label=legend,
                      color=colour_of(runs, run) if len(runs) > 1 else OF_CURVES[k % 4])
    if not any(len(run.table("fractures")["time"]) for run in runs):
        axes.text(0.5, 0.5, "no stone broke", transform=axes.transAxes, ha="center", color=GREY)
        axes.set_xlim(0, max(run.columns["time"][-1] for run in runs))
    axes.set_ylim(0, max(1, axes.get_ylim()[1]))
    axes.set_title("Fractures over time" + (", by size" if len(runs) == 1 else ""))
    axes.set_xlabel("time from the beginning of the history [s]")
    axes.set_ylabel("broken stones [-]")
    whole_numbers(axes.yaxis)
    if axes.get_legend_handles_labels()[0]:
        axes.legend()


def draw_coordination(axes, runs):
    most = int(max(run.table("stones")["coordination"].max() for run in runs))
    for run in runs:
        touching = run.table("stones")["coordination"]
        share = np.bincount(touching.astype(int), minlength=most + 1) / len(touching)
        axes.step(np.arange(-1, most + 2), 100 * np.concatenate([[0], share, [0]]), where="mid",
                  color=colour_of(runs, run))
        axes.axvline(touching.mean(), color=colour_of(runs, run), linestyle=":", linewidth=1)
    axes.set_title("Touching stones at the end (dotted: mean)")
    axes.set_xlabel("neighbours whose shells touch [-]")
    axes.set_xlim(-0.5, most + 1)
    axes.set_ylim(bottom=0)
    axes.set_ylabel("of the stones [%]")
    whole_numbers(axes.xaxis)


def draw_forces(axes, runs):
    """Probability density of normal forces over their mean, as in the literature of granular media
    (Mueth, Jaeger, Nagel 1998): an exponential tail."""
    for run in runs:
        force = run.table("contacts")["normal_force"]
        force = force[force > 0]
        if len(force) == 0:
            continue
        edges = np.linspace(0, max(4, np.quantile(force, 0.999) / force.mean()), 40)
        density, _ = np.histogram(force / force.mean(), edges, density=True)
        middle = (edges[1:] + edges[:-1]) / 2
        seen = density > 0
        axes.semilogy(middle[seen], density[seen], "o", markersize=3, color=colour_of(runs, run),
                      label=f"{len(force)} contacts, mean {force.mean():.2g} N")
    axes.set_xlim(left=0)
    line = np.array(axes.get_xlim())
    low = axes.get_ylim()[0]
    axes.semilogy(line, np.exp(-line), color=GREY, linestyle="--", linewidth=1, label="exp(−f)")
    axes.set_ylim(bottom=low)
    axes.set_title("Forces between stones at the end")
    axes.set_xlabel("normal force / mean [-]")
    axes.set_ylabel("probability density [-]")
    axes.legend()


def stones(runs):
    runs = with_bed(runs)
    if not runs:
        return None
    page = figure(10, 6.6)
    axes = page.subplots(2, 2)
    draw_fractures_over_time(axes[0, 0], runs)
    draw_fractures_by_size(axes[0, 1], runs)
    draw_coordination(axes[1, 0], runs)
    draw_forces(axes[1, 1], runs)
    name_runs(page, runs)
    return page


def points_in_spheres(run, per_stone=300):
    """Points evenly inside every stone with its shell, and the volume that each stands for.

    Shells overlap where stones touch, and are counted twice there, just as the air voids of the
    program count the binder that is squeezed out of such overlaps."""
    k = np.arange(per_stone) + 0.5
    out = np.cbrt(k / per_stone)[:, None]
    turn = np.pi * (1 + np.sqrt(5)) * np.random.default_rng(0).permutation(k)
    up = np.random.default_rng(1).permutation(1 - 2 * k / per_stone)
    around = np.sqrt(1 - up**2)
    unit = out * np.stack([around * np.cos(turn), around * np.sin(turn), up], axis=1)
    table = run.table("stones")
    radius = table["radius"] + table["shell_thickness"][0]
    centre = np.stack([table["x"], table["y"], table["z"]], axis=1)
    points = centre[:, None] + radius[:, None, None] * unit
    volume = np.repeat(4 / 3 * np.pi * radius**3 / per_stone, per_stone)
    return points.reshape(-1, 3), volume


def void_profiles(run, rows=16):
    """Air voids [%] between floor and inclined plate over height [mm], and over radius [mm]."""
    points, volume = points_in_spheres(run)
    radius = run.table("mould")["diameter"][0] / 2
    centre, normal = run.table("head")["centre"], run.table("head")["normal"]
    plate = centre[2] - (points[:, :2] - centre[:2]) @ normal[:2] / normal[2]
    height = centre[2] + centre[:2] @ normal[:2] / normal[2]  # on the axis, and in the mean
    up = np.clip(points[:, 2] / plate, 0, 1 - 1e-12)
    out = np.clip(np.hypot(points[:, 0], points[:, 1]) / radius, 0, 1 - 1e-12)
    filled_rows, edges = np.histogram(up, rows, (0, 1), weights=volume)
    ring = np.array([0, 0.3, 0.45, 0.55, 0.65, 0.75, 0.8, 0.85, 0.9, 0.95, 1])  # finer at the wall
    filled_rings, _ = np.histogram(out, ring, weights=volume)
    whole = np.pi * radius**2 * height
    over_height = 1 - filled_rows / (whole / rows)
    over_radius = 1 - filled_rings / (whole * np.diff(ring**2))
    return (1e3 * height * edges, 100 * over_height), (1e3 * radius * ring, 100 * over_radius)


def voids(runs):
    runs = [run for run in with_bed(runs) if run.table("head")]
    if not runs:
        return None
    page = figure(10, 4)
    by_height, by_radius = page.subplots(1, 2)
    for run in runs:
        colour = colour_of(runs, run)
        (height, over_height), (radius, over_radius) = void_profiles(run)
        by_height.stairs(over_height, height, orientation="horizontal", baseline=None, color=colour)
        by_radius.stairs(over_radius, radius, baseline=None, color=colour)
        mean = 100 * run.columns["air_voids"][-1]
        by_height.axvline(mean, color=colour, linestyle=":", linewidth=1)
        by_radius.axhline(mean, color=colour, linestyle=":", linewidth=1)
    by_height.set_title("Air voids over height (dotted: mean)")
    by_height.set_xlabel("air voids [%]")
    by_height.set_ylabel("height above the floor [mm]")
    by_radius.set_title("Air voids over radius")
    by_radius.set_xlabel("from the axis [mm]")
    by_radius.set_ylabel("air voids [%]")
    name_runs(page, runs)
    return page


def gradation(runs):
    """Asked and got, by mass and by number, as figure 2 of Olsson, Jelagin, Partl."""
    page = figure(10, 3.6)
    by_mass, by_number = page.subplots(1, 2, width_ratios=[1.6, 1])
    for run in runs:
        colour = colour_of(runs, run)
        sieve, passing = run.sieves()
        diameter = np.sort(2 * run.table("stones")["radius"])
        smallest = passing_at(sieve, passing, diameter[0])
        mass = np.cumsum(diameter**3) / np.sum(diameter**3)
        got = smallest + (1 - smallest) * mass
        by_mass.semilogx(1e3 * sieve, 100 * passing, "o", markerfacecolor="none", color=colour,
                         label="asked, at the sieves" if len(runs) == 1 else None)
        by_mass.semilogx(1e3 * diameter, 100 * got, color=colour,
                         label="got" if len(runs) == 1 else None)
        by_number.semilogx(1e3 * diameter, 100 * np.arange(1, len(diameter) + 1) / len(diameter),
                           color=colour)
    by_mass.set_title("Gradation by mass" + (" (circles: asked)" if len(runs) > 1 else ""))
    by_mass.set_ylabel("passing [% of the mass]")
    by_number.set_title("Modelled stones by number")
    by_number.set_ylabel("finer [% of the stones]")
    sieve = 1e3 * runs[0].sieves()[0]
    finest = 1.9e3 * min(run.table("stones")["radius"].min() for run in runs)
    for panel, shown in ((by_mass, sieve), (by_number, sieve[sieve > finest])):
        panel.set_xlabel("sieve [mm]")
        panel.minorticks_off()
        panel.set_xticks(shown, [f"{opening:g}" for opening in shown], fontsize=9)
        panel.set_ylim(0, 105)
    if len(runs) == 1:
        by_mass.legend()
    name_runs(page, runs)
    return page


def passing_at(sieve, passing, diameter):
    """Log-linear between sieves, as the program reads the table."""
    return np.interp(np.log(diameter), np.log(np.maximum(sieve, 1e-9)), passing)
