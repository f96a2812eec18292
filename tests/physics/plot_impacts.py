"""The picture of the eight impacts of Chung & Ooi (2011): dots are what the simulation computes,
lines the closed forms, crosses what was digitised or solved with partial slip. checks.py draws it
from the rows that the tests write; nothing is computed here."""
import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt

COLOURS = ["#2166ac", "#b2182b", "#1b7837", "#762a83"]
STYLE = {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False, "axes.grid": True,
         "axes.axisbelow": True, "grid.color": "#e6e6e6", "legend.frameon": False,
         "axes.titlelocation": "left", "axes.titlesize": 9, "axes.titleweight": "bold"}
LINE, CROSS = "line", "cross"

# Title, axes, and the quantities shown, each with what its reference is drawn as.
PANELS = [
    ("1: two spheres", "overlap [m]", "force [N]",
     [("force / N at an overlap / m, glass", LINE),
      ("force / N at an overlap / m, limestone", LINE)]),
    ("2: sphere on a plane", "overlap [m]", "force [N]",
     [("force / N at an overlap / m, aluminium alloy", LINE),
      ("force / N at an overlap / m, magnesium alloy", LINE)]),
    ("3: damped sphere on a plane", "restitution given", "restitution found",
     [("restitution out over restitution in, aluminium oxide", LINE),
      ("restitution out over restitution in, cast iron", LINE)]),
    ("4: oblique, aluminium oxide", "angle [deg]", "tangential restitution",
     [("tangential restitution at an angle / deg, sliding, aluminium oxide", LINE),
      ("tangential restitution at an angle / deg, spring carrying force", CROSS),
      ("tangential restitution at an angle / deg, slip rings", CROSS),
      ("tangential restitution at an angle / deg, sticking, spring carrying displacement",
       CROSS)]),
    ("4: oblique, aluminium oxide", "angle [deg]", "spin after [rad/s]",
     [("spin after at an angle / deg, sliding, aluminium oxide", LINE),
      ("spin after at an angle / deg, sticking, spring carrying force", CROSS)]),
    ("5: oblique, from slip to stick", "slip before / mu v_n", "slip after / mu v_n",
     [("slip after / (mu v_n) from a slip before / (mu v_n), steel, spring carrying force", CROSS),
      ("slip after / (mu v_n) from a slip before / (mu v_n), steel, slip rings", CROSS),
      ("slip after / (mu v_n) from a slip before / (mu v_n), polyethylene, slip rings", CROSS)]),
    ("5: oblique, sliding", "slip before / mu v_n", "slip taken away / mu v_n",
     [("slip taken away / (mu v_n) from a slip before / (mu v_n), steel", LINE),
      ("slip taken away / (mu v_n) from a slip before / (mu v_n), polyethylene", LINE)]),
    ("6: spinning sphere on a plane", "v_t / v_n", "slip lost / slip before",
     [("slip lost / slip before at v_t / v_n, one sphere, aluminium alloy", LINE),
      ("slip lost / slip before at v_t / v_n, one sphere, nylon", LINE)]),
    ("7: two spheres, opposite spins", "spin before [rad/s]", "spin after [rad/s]",
     [("spin after a spin before / (rad/s), aluminium alloy", LINE),
      ("spin after a spin before / (rad/s), copper", LINE)]),
    ("8: spinning sphere on another", "v_t / v_n", "slip lost / slip before",
     [("slip lost / slip before at v_t / v_n, two spheres, aluminium alloy", LINE),
      ("slip lost / slip before at v_t / v_n, two spheres, nylon", LINE)]),
]


def short(quantity):
    """What tells a quantity from its neighbours in a panel."""
    if ", sliding, " in quantity:
        return "sliding"
    for mark in ("(mu v_n), ", "/ deg, "):
        if mark in quantity:
            return quantity.rsplit(mark, 1)[-1]
    return quantity.rsplit(", ", 1)[-1]


def draw(axes, quantity, kind, rows, colour):
    points = sorted((row["at"], row["computed"], row["reference"], row["source"]) for row in rows
                    if row["quantity"] == quantity and row["at"] == row["at"])
    if not points:
        raise SystemExit(f"no row of {quantity}: have its test and this picture parted?")
    at, computed, reference, source = zip(*points)
    axes.plot(at, computed, "o", color=colour, markersize=4, label=short(quantity))
    if kind == LINE:
        axes.plot(at, reference, color=colour, linewidth=0.9)
    else:
        axes.plot(at, reference, "x-", color=colour, linewidth=0.5, markersize=6,
                  label=source[0].split(",")[0])


def picture(rows):
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(2, 5, figsize=(19, 7.5), layout="constrained")
        for panel, (title, x, y, quantities) in zip(axes.flat, PANELS):
            for (quantity, kind), colour in zip(quantities, COLOURS):
                draw(panel, quantity, kind, rows, colour)
            panel.set(title=title, xlabel=x, ylabel=y)
            panel.legend(fontsize=7)
            bottom, top = panel.get_ylim()
            panel.set_ylim(min(0, bottom), 1.05 * top)
            if x == "overlap [m]":
                panel.ticklabel_format(axis="x", style="sci", scilimits=(-6, -6))
    return figure
