"""Unrolled maps of a mould's inner face over angle and height."""
import numpy as np

from .style import RED, figure

TO_DEGREES, TO_MM, TO_KPA = 180 / np.pi, 1e3, 1e-3


def on_a_grid(angle, height, values):
    """Angles [deg], heights [mm] and a row of values for each height; the face once around, the
    seam repeated on its other side."""
    turns, column = np.unique(np.round((180 - angle) % 360, 6), return_inverse=True)
    levels, row = np.unique(np.round(height, 6), return_inverse=True)
    grid = np.full((len(levels), len(turns)), np.nan)
    grid[row, column] = values
    turns, grid = 180 - turns[::-1], grid[:, ::-1]
    around = np.concatenate([turns[-1:] - 360, turns, turns[:1] + 360])
    return around, levels, np.hstack([grid[:, -1:], grid, grid[:, :1]])


def scale(values):
    """Colours and their limits: around zero where the values have both signs."""
    low, high = values.min(), values.max()
    if low < -0.05 * high:
        most = max(-low, high)
        return {"cmap": "RdBu_r", "vmin": -most, "vmax": most}
    if high - low < 2e-3 * high:  # an even map is one colour
        low, high = 0.999 * low, 1.001 * high
    return {"cmap": "viridis", "vmin": low, "vmax": high or 1}


def draw_map(page, axes, words, angle, height, values):
    """`angle` [deg], `height` [mm]."""
    around, levels, grid = on_a_grid(angle, height, values)
    drawn = axes.pcolormesh(around, levels, grid, shading="gouraud", rasterized=True,
                            **scale(values))
    page.colorbar(drawn, ax=axes, label=words)
    axes.set_ylabel("height [mm]")
    axes.set_xlim(-180, 180)
    axes.set_xticks(range(-180, 181, 60))
    axes.grid(False)


def steel_alone(title, table):
    """A case of wall_stress: what presses on the mould, and how its steel answers."""
    page = figure(8, 7)
    panels = page.subplots(2, 1, sharex=True)
    for axes, words, name in zip(panels, ("traction, outwards [kPa]",
                                          "hoop stress, inner face [kPa]"),
                                 ("traction_Pa", "hoop_stress_Pa")):
        draw_map(page, axes, words, table["angle_deg"], TO_MM * table["height_m"],
                 TO_KPA * table[name])
    panels[-1].set_xlabel("angle [deg]")
    page.suptitle(title)
    return page


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
    angle, height = TO_DEGREES * table["angle"][last], TO_MM * table["height"][last]
    specimen = run.shown("height")[-1]
    for (unrolled, profile), (words, name) in zip(panels, shown):
        draw_map(page, unrolled, words, angle, height, TO_KPA * table[name][last])
        unrolled.set_title(f"{words.split(' [')[0].capitalize()}, "
                           f"mean over gyration {table['gyration'].max():.0f}")
        turns = np.unique(table["gyration"])
        for turn in turns[np.unique(np.linspace(0, len(turns) - 1, 4).astype(int))]:
            at = table["gyration"] == turn
            _, rows, values = on_a_grid(angle, height, TO_KPA * table[name][at])
            shade = 0.75 * (1 - turn / turns[-1])
            profile.plot(values[:, 1:-1].mean(axis=1), rows, color=(shade, shade, shade),
                         label=f"{turn:.0f}")
        profile.set_xlabel(words)
        profile.set_title("Mean around the mould")
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
        rows = run.gyrating()
        for number, gauge in enumerate(run.scene()["output"]["gauge"], 1):
            where = f"{TO_DEGREES * gauge['angle']:g} deg, {TO_MM * gauge['height']:g} mm"
            strain = 1e6 * run.columns[f"gauge_{number}_hoop_strain"][rows]
            axes.plot(run.shown("gyration")[rows], strain, linewidth=0.8,
                      label=where if len(runs) == 1 else f"{run.name}: {where}")
    axes.set_title("Virtual strain gauges on the mould")
    axes.set_xlabel("gyrations [-]")
    axes.set_ylabel("hoop strain [1e-6]")
    axes.legend(title="angle, height", loc="upper left", bbox_to_anchor=(1, 1))
    return page
