"""Where the wall-clock time of a run went."""
from .style import figure

PHASES = [("seconds_settling", "settling", "#8a8a8a"),
          ("seconds_steel_setup", "preparing the steel", "#f4a582"),
          ("seconds_stones", "stones", "#2166ac"),
          ("seconds_steel", "exchange with the steel", "#b2182b"),
          ("seconds_outputs", "wall outputs and energy ledger", "#1b7837"),
          ("seconds_pictures", "pictures", "#762a83")]


def budget(runs):
    runs = [run for run in runs if "seconds_stones" in run.summary]
    if not runs:
        return None
    page = figure(10, 1.5 + 0.45 * len(runs))
    axes = page.subplots()
    left = [0.0] * len(runs)
    known = [run.summary["wall_seconds"] for run in runs]
    for key, words, colour in PHASES + [(None, "all else", "#dddddd")]:
        spent = [run.summary[key] if key else max(0, whole - done)
                 for run, whole, done in zip(runs, known, left)]
        if max(spent) > 1e-3 * max(known):
            total = f", {spent[0]:.{0 if spent[0] >= 10 else 2}f} s" if len(runs) == 1 else ""
            axes.barh([run.name for run in runs], spent, left=left, color=colour,
                      label=words + total, height=0.6)
        left = [a + b for a, b in zip(left, spent)]
    axes.invert_yaxis()
    axes.grid(axis="y", visible=False)
    axes.set_title("Time budget")
    axes.set_xlabel("wall-clock time [s]")
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))
    return page
