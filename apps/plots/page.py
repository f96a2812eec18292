"""The pictures of runs by name, and one page of them that needs no other file."""
import html

from . import budget, compaction, energy, stones, walls

# What is drawn of gyratory runs and of flow tests: name, heading, figure, what it shows.
GYRATORY = [
    ("compaction", "Compaction", compaction.compaction,
     "Air voids over the logarithm of the gyrations (right: share of the theoretical maximum "
     "density), and how far they have fallen since the gyrations began, as figure 4a of Olsson, "
     "Jelagin and Partl."),
    ("head", "Ram and head", compaction.head,
     "What the machine imposes and what it feels. The internal angle is that of the loaded face "
     "after the steel has bent. Eccentricity is the moment on the head over the force on it."),
    ("stones", "Stones", stones.stones,
     "Who broke and when, how many neighbours a stone touches, and how forces are distributed "
     "(dashed: the exponential tail known of granular packings)."),
    ("voids", "Air voids inside", stones.voids,
     "Between floor and inclined plate at the end. Binder that is squeezed out where shells "
     "overlap stays counted where it came from."),
    ("walls", "Mix on the mould", walls.walls,
     "The mould unrolled: traction of the mix on its inner face beside the hoop stress that the "
     "finite elements answer. Red dashes: height of the specimen."),
    ("gauges", "Strain gauges", walls.gauges, ""),
    ("gradation", "Gradation asked and got", stones.gradation,
     "Stones finer than the smallest one belong to the binder phase."),
    ("energy", "Energy", energy.energy, "Everything since the history began."),
    ("filling", "Filling", compaction.filling,
     "The bed comes to rest under its weight, then the head is lowered and the pressure rises."),
    ("budget", "Time", budget.budget, "")]
FLOW = [("flow", "Flow test", compaction.flow,
         "As figure 3 of Olsson, Jelagin and Partl: pressure under the strip and rise of the ten "
         "highest points over the strip's displacement, which is divided by the height of the "
         "bed.")] + [entry for entry in GYRATORY
                     if entry[0] in ("stones", "gradation", "energy")] + [
    ("filling", "Filling", compaction.filling,
     "The bed comes to rest under its weight, then the strip begins to press."),
    ("budget", "Time", budget.budget, "")]
OF_ONE = (walls.walls,)  # drawn of a run by itself only

# The findings shown first, as far as a run has them: key, words, factor, form.
FIRST = [("air_voids_end", "air voids at the end", 100, "{:.2f} %"),
         ("air_voids_start", "before the gyrations", 100, "{:.2f} %"),
         ("height_end_m", "height at the end", 1e3, "{:.2f} mm"),
         ("internal_angle_deg", "internal angle", 1, "{:.4f} deg"),
         ("pressure_largest_Pa", "largest pressure", 1e-3, "{:.0f} kPa"),
         ("uplift_end_m", "uplift at the end", 1e3, "{:.2f} mm"),
         ("stones", "stones", 1, "{:.0f}"),
         ("fractured_stones", "of them broken", 1, "{:.0f}"),
         ("wall_seconds", "taken", 1, "{:.0f} s")]

PAGE = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>{title}</title>
<meta name="viewport" content="width=device-width, initial-scale=1"><style>
body {{ font: 15px/1.45 sans-serif; color: #222; max-width: 1050px; margin: 2em auto;
       padding: 0 1em }}
svg {{ width: 100%; height: auto }} td, th {{ text-align: left; padding: .15em 1.2em .15em 0;
  vertical-align: top; overflow-wrap: anywhere }}
th {{ font-weight: normal; color: #666 }} th:first-child, td:first-child {{ white-space: nowrap }}
pre {{ background: #f5f5f5; padding: 1em; overflow-x: auto }} h2 {{ margin: 2.2em 0 .3em }}
p {{ color: #555; max-width: 48em }} summary {{ cursor: pointer; margin: 1em 0; color: #2166ac }}
.first {{ display: flex; flex-wrap: wrap; gap: .6em 1.8em; margin: 1em 0 }}
.first b {{ display: block; font-size: 1.5em; font-weight: 600 }} .first span {{ color: #666 }}
nav {{ margin: 1.2em 0 }} nav a {{ color: #2166ac; margin-right: 1.2em }}
</style></head><body><h1>{title}</h1>
{body}
</body></html>
"""


def figures(runs):
    """Name, heading, figure and words of everything that can be drawn of all these runs."""
    if not all(run.began for run in runs):
        yield "filling", "Filling", compaction.filling(runs), "The history has not begun yet."
        return
    for name, heading, draw, words in GYRATORY if runs[0].gyratory else FLOW:
        if draw not in OF_ONE:
            drawn = draw(runs)
        else:
            drawn = draw(runs[0]) if len(runs) == 1 else None
        if drawn:
            yield name, heading, drawn, words


def embedded(svg):
    """A picture as text for a page that needs no other file."""
    text = svg.read_text()
    return text[text.index("<svg"):]


def table(rows, head):
    lines = ["<tr>" + "".join(f"<th>{html.escape(word)}</th>" for word in head) + "</tr>"]
    for row in rows:
        cells = "".join(f"<td>{html.escape(str(word))}</td>" for word in row)
        lines.append(f"<tr>{cells}</tr>")
    return "<table>" + "\n".join(lines) + "</table>"


def short(value):
    return f"{value:.6g}" if isinstance(value, float) else value


def folded(words, content):
    return f"<details><summary>{html.escape(words)}</summary>{content}</details>"


def first_findings(runs):
    shown = [(words, [form.format(run.summary[key] * factor) if key in run.summary else ""
                      for run in runs])
             for key, words, factor, form in FIRST if any(key in run.summary for run in runs)]
    unfinished = "".join(f"<p>{html.escape(run.name)} is not finished.</p>" for run in runs
                         if not run.summary)
    if len(runs) > 1:
        return unfinished + table([[words, *values] for words, values in shown],
                                  ["", *(run.name for run in runs)])
    blocks = [f"<div><b>{values[0]}</b><span>{words}</span></div>" for words, values in shown]
    return unfinished + '<div class="first">' + "".join(blocks) + "</div>"


def summaries(runs):
    keys = dict.fromkeys(key for run in runs for key in run.summary)
    rows = [[key] + [short(run.summary.get(key, "")) for run in runs] for key in keys]
    return table(rows, ["finding"] + [run.name for run in runs])


def origin(run):
    rows = [(key, run.provenance[key]) for key in
            ("program", "version", "compiler", "flags", "seed", "command_line")]
    return table(rows, ("what", "value")) + f"<pre>{html.escape(run.scene_text())}</pre>"


def report(runs, pictures, drawn):
    """The page; `drawn`: name, heading and words of what lies in the folder of pictures."""
    body = [first_findings(runs)]
    body.append("<nav>" + " ".join(f'<a href="#{name}">{html.escape(heading)}</a>'
                                   for name, heading, _ in drawn) + "</nav>")
    for name, heading, words in drawn:
        body.append(f'<h2 id="{name}">{html.escape(heading)}</h2><p>{html.escape(words)}</p>')
        body.append(embedded(pictures / f"{name}.svg"))
    body.append('<h2>Everything else</h2>' + folded("All findings", summaries(runs)))
    for run in runs:
        body.append(folded(f"Where {run.name} comes from: program and scene", origin(run)))
    title = html.escape(runs[0].name if len(runs) == 1 else f"{len(runs)} runs compared")
    return PAGE.format(title=title, body="\n".join(body))
