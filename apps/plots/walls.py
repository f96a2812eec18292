"""Unrolled maps of a mould's inner face over angle and height."""
import numpy as np
from matplotlib.ticker import MaxNLocator

from .style import RED, figure


def draw_map(page, axes, words, angle, height, values):
    """`angle` [deg], `height` [mm]; the face once around, the seam repeated on its other side."""
    seam, far = angle < -90, angle > 90
    around = np.concatenate([angle, angle[seam] + 360, angle[far] - 360])
    up = np.concatenate([height, height[seam], height[far]])
    all_values = np.concatenate([values, values[seam], values[far]])
    low, high = values.min(), values.max()
    signed = low < -0.05 * high
    if signed:
        high = max(-low, high)
        low = -high
    levels = MaxNLocator(20).tick_values(low, max(high, low + 1e-12))
    filled = axes.tricontourf(around, up, all_values, levels=levels,
                              cmap="RdBu_r" if signed else "viridis")
    for band in filled.collections:
        band.set_edgecolor("face")  # no seams between the bands
    page.colorbar(filled, ax=axes, label=words)
    axes.set_ylabel("height [mm]")
    axes.set_xlim(-180, 180)
    axes.set_xticks(range(-180, 181, 60))
    axes.grid(False)


def walls(run):
    """Traction of the mix and hoop stress of the steel side by side: the last gyration's mean, and
    how their means over height developed."""
    table = run.table("walls/mould")
    if not table:
        return None
    last = table["gyration"] == table["gyration"].max()
    shown = [("normal traction [kPa]", "normal_traction"),
             ("axial traction, upwards [kPa]", "axial_traction")]
    if "hoop_stress" in table:
        shown.insert(1, ("hoop stress of the steel [kPa]", "hoop_stress"))
    page = figure(11, 3.6 * len(shown))
    panels = page.subplots(len(shown), 2, width_ratios=[2.2, 1])
    angle, height = np.degrees(table["angle"][last]), 1e3 * table["height"][last]
    specimen = run.shown("height")[-1]
    for (unrolled, profile), (words, name) in zip(panels, shown):
        draw_map(page, unrolled, words, angle, height, 1e-3 * table[name][last])
        unrolled.set_title(f"{words.split(' [')[0].capitalize()}, "
                           f"mean over gyration {table['gyration'].max():.0f}")
        turns = np.unique(table["gyration"])
        for turn in turns[np.unique(np.linspace(0, len(turns) - 1, 4).astype(int))]:
            at = table["gyration"] == turn
            rows, where = np.unique(np.round(1e6 * table["height"][at]), return_inverse=True)
            mean = np.bincount(where, 1e-3 * table[name][at]) / np.bincount(where)
            shade = 0.75 * (1 - turn / turns[-1])
            profile.plot(mean, 1e-3 * rows, color=(shade, shade, shade), label=f"{turn:.0f}")
        profile.set_xlabel(words)
        profile.set_title("Around the mould, by gyration")
        for panel in (unrolled, profile):
            panel.axhline(specimen, color=RED, linewidth=1, linestyle="--")
            panel.set_ylim(0, min(height.max(), 1.5 * specimen))
    panels[-1, 0].set_xlabel("angle [deg]")
    panels[0, 1].legend(title="gyration")
    return page


def gauges(runs):
    """Hoop strain under the virtual gauges over the last gyrations."""
    runs = [run for run in runs if "gauge_1_hoop_strain" in run.columns]
    if not runs:
        return None
    page = figure(10, 3.2)
    axes = page.subplots()
    for run in runs:
        names = [name for name in run.columns if name.endswith("_hoop_strain")]
        for name in names:
            label = name.split("_")[1] if len(runs) == 1 else f"{run.name}, {name.split('_')[1]}"
            axes.plot(run.shown("gyration")[run.gyrating()],
                      1e6 * run.columns[name][run.gyrating()], linewidth=0.8, label=label)
    axes.set_title("Virtual strain gauges on the mould")
    axes.set_xlabel("gyrations [-]")
    axes.set_ylabel("hoop strain [1e-6]")
    axes.legend(title="gauge", loc="upper left", bbox_to_anchor=(1, 1))
    return page
