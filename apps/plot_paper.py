#!/usr/bin/python3
"""Holds the paper against studies of its mixes: plot_paper.py STUDY_DIR ... [--page paper.md]

Takes what trade left of apps/scenes/studies/paper_*.toml, draws the figures of Olsson, Jelagin &
Partl anew (3a and 3b of a flow test, 4a and 4b of gyratory compaction) and writes every statement
of theirs with what is found. A study is a section of the page, and takes the place of the one
that had its heading; the others stay as they are."""
import argparse
import pathlib
import re
import sys
import time

import matplotlib.pyplot as plt
import numpy as np

from plots.errors import InputError, exit_status_of, reading
from plots.mixes import (bed_height, box, broken, compare, compression, contact_force, decrease,
                         depth, difference, internal_angle, late_rise, lowest, mean, mixes,
                         of_all_runs, over_seeds, paired, per_decade, pressure, roughness, sinking,
                         sizes_of_broken, stones_of, stretch, told, traction, turns, uplift,
                         voids_before, with_rigid_steel)
from plots.study import runs_by_setting
from plots.style import BLUE, GREY, RED, STYLE, save

PAPER_BOX = 0.150, 0.100  # length and width [m], Olsson, Jelagin & Partl, section 3.2
STUDIES = pathlib.Path(__file__).parent / "scenes" / "studies"
PREAMBLE = """# The paper's study, run and compared

SMA 11 and AC 11, 110 and 150 degC, two binder contents each. Where two are compared, "agrees" and
"against" are said if they differ by more than chance: +- is what the mean is off by in 1 of 20
cases (Student), where runs of a seed count as one, since they begin with the same places; in the
tables of configurations it is the standard error. Where the paper gives a number, the remark says
what counts as agreeing. "In part": compression or uplift is more than chance, not both,
or the bed does not come above where it began.
"""


def flow_statements(flow):
    """The paper's statements on the flow test: what was found, whether it agrees, and a remark."""
    end, sunk, down, up = (mean(flow, of) for of in (uplift, sinking, compression, late_rise))
    shown = [down[0] > down[1], up[0] > up[1]]
    yield ("Initially a compression, eventually an uplift (3.2)",
           f"down by {down[0]:.2f} mm (+-{down[1]:.2g}), later up by {up[0]:.2f} (+-{up[1]:.2g}) to "
           f"{end[0]:+.2f} mm (+-{end[1]:.2g})",
           "agrees" if all(shown) and end[0] > end[1] else "in part" if any(shown)
           else "not shown",
           f"down: until a quarter of the way, from {sunk[0]:.2f} mm on, where the strip begins to "
           "press with 1 kPa and the bed has sunk by its weight; up: over the second half of "
           f"{1e3 * depth(flow):.0f} mm; agrees: and the end is above 0")
    highest = max(mix.values(uplift).max() for mix in flow.values())
    of_the_paper = np.allclose(box(flow), PAPER_BOX)
    yield ("An uplift of up to 5 mm (3.2)", f"{highest:+.2f} mm, the largest of all runs",
           "not compared" if not of_the_paper else "agrees" if 2.5 < highest < 7.5 else "against",
           "agrees: half to one and a half of it" if of_the_paper else "the box is a smaller one")
    yield ("The uplift increases with decreasing temperature (3.2)",
           *compare(flow, uplift, 1, 110, 150, "mm"), "110 against 150 degC")
    yield ("The uplift increases with decreasing binder content (3.2)",
           *compare(flow, uplift, 2, 0, 1, "mm"), "")
    yield ("A stiffer sample at lower temperature (3.2)",
           *compare(flow, pressure, 1, 110, 150, "kPa"), "mean pressure, second half of the way")
    yield ("A stiffer sample with less binder (3.2)",
           *compare(flow, pressure, 2, 0, 1, "kPa"), "the same")
    rough = mean(flow, roughness)
    yield ("The response is noisy, as only large stones are modelled (3.2)",
           f"the pressure is {rough[0]:.1f} % (+-{rough[1]:.1g}) off a smooth curve",
           "agrees" if rough[0] - rough[1] > 5 else "against" if sum(rough) < 5
           else "not told apart",
           "a cubic over the second half of the way, rms; agrees: above 5 %; that it is the large "
           "stones is not tried")
    yield ("Far weaker than the experiment (3.2)", "", "not compared",
           "the experiment's pressures are in a figure that is not at hand")
    yield ("Lower temperature: more frequent damage (3.3)",
           *compare(flow, broken, 1, 110, 150, "stones"), "flow test")


def gyratory_statements(gyratory):
    """The same on gyratory compaction."""
    count = stones_of(gyratory)
    most_broken = max(mix.values(broken).max() for mix in gyratory.values())
    share = mean(gyratory, broken)[0] / count
    yield ("Fracture is very rare: 0 to 4 of 5000 stones (3.3)",
           f"0 to {most_broken:.0f} of {count}, mean {100 * share:.2g} %",
           "agrees" if share <= 4 / 5000 else "against",
           f"in the mould, {plural(round(turns(gyratory)), 'gyration')}; agrees: a mean of up to 4 of "
           "5000; strength by size is the paper's")
    yield ("Lower temperature: a stiffer response (3.3)",
           *compare(gyratory, decrease, 1, 150, 110, "%"),
           "air-void decrease, 150 against 110 degC")
    yield ("Lower temperature: increasing contact forces (3.3)",
           *compare(gyratory, contact_force, 1, 110, 150, "N"),
           "mean of the normal forces between stones that press, at the end")
    yield ("Lower temperature: more frequent damage (3.3)",
           *compare(gyratory, broken, 1, 110, 150, "stones"), "in the mould")
    if turns(gyratory) < 1.5:
        return
    first = mean(gyratory, lambda run: np.interp(1, run.columns["gyration"],
                                                 run.columns["air_voids_decrease"]))
    whole = mean(gyratory, decrease)
    yield ("Overestimated compressibility in the first gyrations (3.3)",
           f"{100 * first[0]:.2f} % of volume after the first, {whole[0]:.2f} % in all",
           "not compared", "the experiment's curve is in a figure that is not at hand")
    slope = mean(gyratory, per_decade)
    yield ("(published) 6 to 8 %Gmm per decade of gyrations",
           f"{slope[0]:.2g} (+-{slope[1]:.1g}) from gyration 0.5 on",
           "agrees" if 6 <= slope[0] <= 8 else "against",
           "agrees: within; two gyrations are too few, and inertia takes its part: over fifty it "
           "comes nearer ([trade.md](trade.md)); the binder never relaxes wholly; range from memory")


def steel_rows(elastic, rigid):
    """What the steel changes, quantity by quantity, in one configuration."""
    for words, unit, of in (("internal angle", "deg", internal_angle),
                            ("air-void decrease", "%", decrease),
                            ("traction of the mould", "kPa", traction),
                            ("broken stones", "-", broken)):
        one, other = (over_seeds([values])[0] for values in paired(elastic, rigid, of))
        apart, error = over_seeds([difference(elastic, rigid, of)])
        yield (f"| {words} [{unit}] | {one:.4g} | {other:.4g} | {apart:+.2g} "
               f"| {error:.2g} | {'yes' if abs(apart) > error else 'not told apart'} |\n")


def flow_rows(flow):
    """What each configuration has found in the flow test, over its seeds."""
    for mix in flow.values():
        yield (f"| {mix.name} | {told(mix, sinking, '.2f')} | {told(mix, lowest, '.2f')} "
               f"| {told(mix, uplift, '.2f')} | {told(mix, pressure, '.0f')} "
               f"| {', '.join(f'{n:.0f}' for n in mix.values(broken))} |\n")


def gyratory_rows(gyratory):
    """The same in the mould."""
    for mix in gyratory.values():
        yield (f"| {mix.name} | {told(mix, voids_before, '.1f')} | {told(mix, decrease, '.2f')} "
               f"| {told(mix, traction, '.0f')} | {told(mix, internal_angle, '.4f')} "
               f"| {', '.join(f'{n:.0f}' for n in mix.values(broken))} |\n")


def what_breaks(flow):
    """Which stones, and how far bonds stretch before they part."""
    size, (apart, shells) = of_all_runs(flow, sizes_of_broken), of_all_runs(flow, stretch)
    words, bonds = "", apart > 0
    if len(size):
        words += (f"Of the {len(size)} broken stones {100 * np.mean(size >= 0.8):.0f} % are of the "
                  f"largest fifth, {100 * np.mean(size < 0.2):.0f} % of the smallest.\n")
    if bonds.any():
        words += (f"At the end {100 * np.mean(bonds):.0f} % of the contacts between stones are "
                  f"stretched bonds, {100 * np.mean(shells[bonds] > 1):.0f} % of these by more than "
                  f"the film of both shells, the longest by {1e3 * apart.max():.1f} mm.\n")
    return words and "\n" + words


def plural(count, word):
    return f"{count} {word}{'s' * (count > 1)}"


def conditions(study):
    """Box, seeds and inertia of a study, in words."""
    one = next(iter(study.values()))
    scene = one.runs[0].scene()
    size = [f"{1e3 * edge:.0f}" for edge in box(study)]
    place = (f"In a box of {' x '.join(size)} mm" if size
             else f"Elastic steel, {plural(round(turns(study)), 'gyration')}")
    seeds = max(len(mix.runs) for mix in study.values())
    return (f"{place}; {plural(seeds, 'seed')}, `{scene['run']['fidelity']}`"
            + f" with mass scale {scene['numerics']['mass_scale']:.2g}".replace("e+0", "e")
            + " on the smallest stones" * bool(scene["numerics"].get("selective_mass"))
            + "".join(f". Left out, {mix.name}, {seed}: {why.strip()}"
                      for mix in study.values() for seed, why in mix.stopped.items())
            + "".join(f". Of {mix.name} {len(mix.runs)}" for mix in study.values()
                      if len(mix.runs) < seeds))


def looks(key):
    """Of the curve of a configuration."""
    return {"color": RED if key[1] == 150 else BLUE, "alpha": 1 if key[2] else 0.55,
            "linestyle": "-" if key[0].startswith("SMA") else "--"}


def draw_flow(flow, left, right):
    way = np.linspace(0, depth(flow), 200)[1:]
    for key, mix in flow.items():
        share = way / np.mean(mix.values(bed_height))
        left.plot(share, 1e-3 * mix.curve("displacement", "pressure", way), **looks(key),
                  label=mix.name)
        right.plot(share, 1e3 * mix.curve("displacement", "uplift", way), **looks(key))
    left.set(title="Figure 3a: flow test", xlabel="displacement / height of the bed",
             ylabel="pressure [kPa]")
    left.legend(fontsize=7)
    right.set(title="Figure 3b", xlabel="displacement / height of the bed", ylabel="uplift [mm]")


def draw_gyratory(gyratory, left, right):
    way = np.linspace(0, turns(gyratory), 200)[1:]
    for key, mix in gyratory.items():
        left.plot(way, 100 * mix.curve("gyration", "air_voids_decrease", way), **looks(key),
                  label=mix.name)
    left.set(title="Figure 4a: gyratory compaction", xlabel="gyrations",
             ylabel="air-void decrease [%]")
    left.legend(fontsize=7)
    counts = [mix.values(broken) for mix in gyratory.values()]
    right.barh(range(len(counts)), [np.mean(n) for n in counts], color=GREY)
    for place, seeds in enumerate(counts):
        right.plot(seeds, [place] * len(seeds), "o", color=RED, markersize=4)
    right.set_yticks(range(len(counts)), [mix.name for mix in gyratory.values()], fontsize=8)
    right.invert_yaxis()
    right.set_xlim(-0.1, max(4, 1.1 * max(n.max() for n in counts)))
    right.set(title="Figure 4b: broken stones, dots: seeds",
              xlabel=f"broken stones of {stones_of(gyratory)}")


def statement_table(statements):
    text = "\n| the paper says | found | | remark |\n|---|---|---|---|\n"
    return text + "".join("| " + " | ".join(row) + " |\n" for row in statements)


def flow_tables(flow):
    return statement_table(flow_statements(flow)) + """
Uplift when the strip begins to press (1 kPa), at its lowest and at the end:

| configuration | begins [mm] | lowest [mm] | end [mm] | pressure, second half [kPa] | broken |
|---|---:|---:|---:|---:|---:|
""" + "".join(flow_rows(flow)) + what_breaks(flow)


def gyratory_tables(gyratory, elastic, rigid):
    return statement_table(gyratory_statements(gyratory)) + """
| configuration | voids before [%] | decrease [%] | mould [kPa] | internal angle [deg] | broken |
|---|---:|---:|---:|---:|---:|
""" + "".join(gyratory_rows(gyratory)) + """
What the steel changes: elastic mould and head against rigid ones, paired by seed, in SMA 11 at 150
degC with 6.6 %.

| quantity | elastic | rigid | difference | +- | changed |
|---|---:|---:|---:|---:|---|
""" + "".join(steel_rows(elastic, rigid))


def section(folder):
    """Of a study: heading and all of its section, its picture and the name of that."""
    runs = runs_by_setting(folder)
    study = mixes(folder, runs)
    one = next(iter(study.values())).runs[0]
    own = folder.resolve().name
    if not (STUDIES / f"{own}.toml").exists():
        raise InputError(f"{folder}: expected the name of a study of {STUDIES}, found {own}; "
                         "rename it")
    if one.gyratory:
        test, draw = "Gyratory compaction", draw_gyratory
        key, rigid = with_rigid_steel(folder, runs)
        tables = gyratory_tables(study, study[key], rigid)
    else:
        test, draw, tables = "Flow test", draw_flow, flow_tables(study)
    heading = f"## {test}, {stones_of(study)} stones\n"
    picture = f"paper_{test.split()[0].lower()}_{stones_of(study)}.png"
    figure, axes = plt.subplots(1, 2, figsize=(12, 4.3))
    draw(study, *axes)
    made = time.strftime("%Y-%m-%d", time.gmtime((one.folder / "summary.json").stat().st_mtime))
    return heading, heading + f"""
Made on {made} by

    build/bin/trade apps/scenes/studies/{own}.toml --out {own}
    apps/plot_paper.py {own} --page apps/docs/paper.md

{conditions(study)}.

![the paper's figures anew]({picture})
""" + tables, figure, picture


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("studies", type=pathlib.Path, nargs="+")
    parser.add_argument("--page", type=pathlib.Path, default=pathlib.Path("paper.md"))
    options = parser.parse_args()
    with reading(options.page, "a page of text", "choose another --page"):
        text = options.page.read_text() if options.page.exists() else PREAMBLE
    with plt.rc_context(STYLE):
        sections = [section(folder) for folder in options.studies]  # before anything is written
        options.page.parent.mkdir(parents=True, exist_ok=True)
        for _, _, figure, picture in sections:
            save(figure, options.page.parent / picture, dpi=100)
    for heading, words, _, _ in sections:
        print(words)
        before = re.search(rf"^{re.escape(heading)}.*?(?=^## |\Z)", text, re.MULTILINE | re.DOTALL)
        if before:
            rest = text[before.end():]
            text = text[:before.start()] + words + ("\n" + rest if rest else "")
        else:
            text += "\n" + words
    part = options.page.with_name(".part_" + options.page.name)  # replaced as a whole
    part.write_text(text)
    part.replace(options.page)


if __name__ == "__main__":
    sys.exit(exit_status_of(main))
