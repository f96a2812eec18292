"""How the pictures look, and what they are drawn with."""
import itertools

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt  # noqa: E402
from matplotlib.lines import Line2D  # noqa: E402

INK, BLUE, RED, GREEN, GREY = "#222222", "#2166ac", "#b2182b", "#1b7837", "#8a8a8a"
OF_CURVES = (BLUE, RED, GREEN, "#762a83")
LINES = ("-", "--", ":", "-.")

STYLE = {
    "font.size": 10,
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": INK,
    "axes.titlelocation": "left",
    "axes.titlesize": 11,
    "axes.titleweight": "bold",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.ymargin": 0.08,
    "grid.color": "#e6e6e6",
    "legend.frameon": False,
    "lines.linewidth": 1.5,
    "figure.constrained_layout.use": True,
    "svg.hashsalt": "gyratory",
}


def figure(width, height):
    return plt.figure(figsize=(width, height), layout="constrained")


def save(figure, out, dpi):
    """Replaces the picture as a whole, for viewers that watch it, and lest half of one is left."""
    part = out.with_name(".part_" + out.name)  # the ending tells matplotlib the format
    figure.savefig(part, dpi=dpi)
    part.replace(out)


def colour_of(runs, run):
    """Of a run among several; of the first of several curves where it is alone."""
    return BLUE if len(runs) == 1 else f"C{runs.index(run)}"


def name_runs(page, runs):
    """A legend of the runs above the panels, where there are several."""
    if len(runs) == 1:
        return
    handles = [Line2D([], [], color=colour_of(runs, run), label=run.name) for run in runs]
    widest = 6 + max(len(run.name) for run in runs)
    columns = min(len(runs), max(1, int(10 * page.get_figwidth()) // widest))
    lines = -(-len(runs) // columns)
    page.suptitle("\n" * lines, fontsize=10)  # its place is kept free of panels
    page.legend(handles=handles, loc="upper left", ncols=columns)


def curves(axes, runs, x, drawn, title, quantity, rows=None):
    """Draws `drawn`, each a (column, legend), of every run over `x`, a (column, words).

    One run has a colour for each curve; of several each has its colour, each curve its dashes."""
    alone = len(runs) == 1
    for run in runs:
        some = rows(run) if rows else slice(None)
        for (column, legend), colour, dashes in zip(drawn, OF_CURVES, itertools.cycle(LINES)):
            if column not in run.columns:
                continue
            axes.plot(run.shown(x[0])[some], run.shown(column)[some],
                      color=colour if alone else colour_of(runs, run),
                      linestyle="-" if alone else dashes, label=legend)
    axes.set_title(title)
    axes.set_xlabel(runs[0].label(x[1], x[0]))
    axes.set_ylabel(runs[0].label(quantity, drawn[0][0]))
    if len(drawn) > 1:
        handles = [Line2D([], [], color=colour if alone else INK,
                          linestyle="-" if alone else dashes, label=legend)
                   for (_, legend), colour, dashes in zip(drawn, OF_CURVES, itertools.cycle(LINES))]
        axes.margins(y=0.3)  # room for the legend
        axes.legend(handles=handles, loc="upper center", ncols=len(drawn))


def whole_numbers(axis):
    axis.set_major_locator(matplotlib.ticker.MaxNLocator(integer=True))
