#!/usr/bin/env python3
"""Holds the paper against its study:
plot_paper.py GYRATORY_DIR FLOW_DIR [--full DIR] [--small DIR] [--out DIR]

Takes what trade left of apps/scenes/studies/paper_gyratory.toml and paper_flow_5000.toml, with
--full of paper_gyratory_5000.toml and with --small of paper_flow.toml, draws the figures of Olsson,
Jelagin & Partl anew (paper.png: 3a, 3b, 4a, 4b) and writes every statement of theirs with what is
found (paper.md)."""
import argparse
import pathlib

import matplotlib.pyplot as plt
import numpy as np

from plots.mixes import (Mix, broken, compare, decrease, depth, internal_angle, lowest, mean, mixes,
                         name, per_decade, pressure, rise, sinking, spread, stones_of, told,
                         traction, uplift, voids_before)
from plots.style import BLUE, GREY, RED, STYLE


def flow_statements(flow):
    """The paper's statements on the flow test: what was found, whether it agrees, and a remark."""
    least, most, sunk = mean(flow, lowest), mean(flow, uplift), mean(flow, sinking)
    risen = mean(flow, rise)
    yield ("Initially a compression, eventually an uplift (3.2)",
           f"lowest {least[0]:.2f} mm, from there up by {risen[0]:.2f} (+-{risen[1]:.2g}) to "
           f"{most[0]:+.2f} mm (+-{most[1]:.2g})",
           "agrees" if least[0] < 0 < most[0] - 2 * most[1]
           else "in part" if least[0] < 0 < risen[0] - 2 * risen[1] else "not shown",
           f"{sunk[0]:.2f} mm under its weight, before the strip presses with 1 kPa; "
           f"the strip goes {1e3 * depth(flow):.0f} mm deep")
    yield ("The uplift increases with decreasing temperature (3.2)",
           *compare(flow, uplift, 1, 110, 150, "mm"), "110 against 150 degC")
    yield ("The uplift increases with decreasing binder content (3.2)",
           *compare(flow, uplift, 2, 0, 1, "mm"), "")
    yield ("A stiffer sample at lower temperature (3.2, 3.3)",
           *compare(flow, pressure, 1, 110, 150, "kPa"), "mean pressure, second half of the way")
    yield ("Lower temperature: more frequent damage (3.3)",
           *compare(flow, broken, 1, 110, 150, "stones"), "flow test")


def gyratory_statements(gyratory, pressed):
    """The same on gyratory compaction; broken stones are counted in `pressed`."""
    count = stones_of(pressed)
    most_broken = max(mix.values(broken).max() for mix in pressed.values())
    share = mean(pressed, broken)[0] / count
    yield ("Fracture is very rare: 0 to 4 of 5000 stones (3.3)",
           f"0 to {most_broken:.0f} of {count}, mean {100 * share:.2g} %",
           "agrees" if share <= 4 / 5000 else "against",
           "in the mould; strength by size is the paper's")
    first = mean(gyratory, lambda run: np.interp(1, run.columns["gyration"],
                                                 run.columns["air_voids_decrease"]))
    whole = mean(gyratory, decrease)
    yield ("Overestimated compressibility in the first gyrations (3.3)",
           f"{100 * first[0]:.2f} % of volume after the first, {whole[0]:.2f} % after two",
           "agrees" if 100 * first[0] > whole[0] / 2 else "against", "")
    slope = mean(gyratory, per_decade)
    yield ("(published) 6 to 8 %Gmm per decade of gyrations",
           f"{slope[0]:.2g} (+-{slope[1]:.1g}) over gyrations 0.5 to 2",
           "agrees" if 6 <= slope[0] <= 8 else "against",
           "two gyrations are too few, and inertia takes its part: over fifty it comes nearer "
           "([trade.md](trade.md)); the binder never relaxes wholly; range from memory")


def table_of(statements):
    text = "\n| the paper says | found | | remark |\n|---|---|---|---|\n"
    return text + "".join("| " + " | ".join(row) + " |\n" for row in statements)


def steel_rows(study):
    """What the steel changes, quantity by quantity, in one configuration."""
    chosen = name("SMA 11", 150, "6.6")
    elastic, rigid = Mix(study, chosen), Mix(study, chosen + ", rigid steel")
    for words, unit, of in (("internal angle", "deg", internal_angle),
                            ("air-void decrease", "%", decrease),
                            ("traction of the mould", "kPa", traction),
                            ("broken stones", "-", broken)):
        one, other = elastic.values(of), rigid.values(of)
        apart, error = spread(one - other)
        yield (f"| {words} [{unit}] | {np.mean(one):.4g} | {np.mean(other):.4g} | {apart:+.2g} "
               f"| {error:.1g} |\n")


def flow_rows(flow):
    """What each configuration has found in the flow test, over its seeds."""
    for mix in flow.values():
        yield (f"| {mix.name} | {told(mix, sinking, '.2f')} | {told(mix, lowest, '.2f')} "
               f"| {told(mix, uplift, '.2f')} "
               f"| {told(mix, pressure, '.0f')} "
               f"| {', '.join(f'{n:.0f}' for n in mix.values(broken))} |\n")


def sizes(study):
    """Stones, seeds and inertia of a study, in words."""
    one = next(iter(study.values()))
    scene = one.runs[0].scene()
    box = scene.get("flow")
    return (f"{stones_of(study)} stones"
            + (f" in a box of {1e3 * box['length']:.0f} x {1e3 * box['width']:.0f} mm"
               if box else "")
            + f", {len(one.runs)} seed{'s' * (len(one.runs) > 1)}, `{scene['run']['fidelity']}`"
            + f" with mass scale {scene['numerics']['mass_scale']:.0e}".replace("e+0", "e")
            + (" on the smallest stones" if scene["numerics"].get("selective_mass") else ""))


def full_rows(full):
    """What each configuration has found at the paper's number of stones, over its seeds."""
    for mix in full.values():
        yield (f"| {mix.name} | {told(mix, voids_before, '.1f')} | {told(mix, decrease, '.2f')} "
               f"| {told(mix, traction, '.0f')} | {told(mix, internal_angle, '.4f')} "
               f"| {', '.join(f'{n:.0f}' for n in mix.values(broken))} |\n")


def draw(gyratory, flow, pressed, out):
    with plt.rc_context(STYLE):
        figure, axes = plt.subplots(2, 2, figsize=(12, 8.5))
        a, b, c, d = axes.flat
        way = np.linspace(0, depth(flow), 200)[1:]
        turns = np.linspace(0, 2, 200)[1:]
        style = lambda key: {"color": RED if key[1] == 150 else BLUE,
                             "alpha": 1 if key[2] else 0.55,
                             "linestyle": "-" if key[0].startswith("SMA") else "--"}
        for key, mix in flow.items():
            a.plot(1e3 * way, 1e-3 * mix.curve("displacement", "pressure", way), **style(key),
                   label=mix.name)
            b.plot(1e3 * way, 1e3 * mix.curve("displacement", "uplift", way), **style(key))
        for key, mix in gyratory.items():
            c.plot(turns, 100 * mix.curve("gyration", "air_voids_decrease", turns), **style(key))
        a.set(title="Figure 3a: flow test", xlabel="displacement [mm]", ylabel="pressure [kPa]")
        a.legend(fontsize=7)
        b.set(title="Figure 3b", xlabel="displacement [mm]", ylabel="uplift [mm]")
        c.set(title="Figure 4a: gyratory compaction", xlabel="gyrations",
              ylabel="air-void decrease [%]")
        counts = [mix.values(broken) for mix in pressed.values()]
        d.barh(range(len(counts)), [np.mean(n) for n in counts], color=GREY)
        for place, seeds in enumerate(counts):
            d.plot(seeds, [place] * len(seeds), "o", color=RED, markersize=4)
        d.set_yticks(range(len(counts)), [mix.name for mix in pressed.values()], fontsize=8)
        d.invert_yaxis()
        d.set_xlim(-0.1, max(4, 1.1 * max(n.max() for n in counts)))
        d.set(title="Figure 4b: broken stones, dots: seeds",
              xlabel=f"broken stones of {stones_of(pressed)}")
        figure.savefig(out / "paper.png", dpi=100)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("gyratory", type=pathlib.Path)
    parser.add_argument("flow", type=pathlib.Path)
    parser.add_argument("--full", type=pathlib.Path, help="the study with 5000 stones")
    parser.add_argument("--small", type=pathlib.Path, help="the flow test in half the box")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."))
    options = parser.parse_args()
    options.out.mkdir(parents=True, exist_ok=True)
    gyratory, flow = mixes(options.gyratory), mixes(options.flow)
    full = mixes(options.full) if options.full else None
    pressed = full or gyratory
    draw(gyratory, flow, pressed, options.out)
    text = f"""# The paper's study, run and compared

Made by

    build/bin/trade apps/scenes/studies/paper_gyratory.toml --out paper_gyratory
    build/bin/trade apps/scenes/studies/paper_gyratory_5000.toml --out paper_gyratory_5000
    build/bin/trade apps/scenes/studies/paper_flow_5000.toml --out paper_flow_5000
    build/bin/trade apps/scenes/studies/paper_flow.toml --out paper_flow
    python3 apps/plot_paper.py paper_gyratory paper_flow_5000 --full paper_gyratory_5000 \\
        --small paper_flow --out apps/docs

SMA 11 and AC 11, 110 and 150 degC, two binder contents each.
Flow test: {sizes(flow)}.
Gyratory compaction: {sizes(gyratory)}, two gyrations.
"Agrees" and "against" are said where the difference is beyond twice its standard error over
configurations and seeds, paired where two are compared; "in part": the uplift rises, but not above
where the bed began.

![Figures 3 and 4 anew](paper.png)
"""
    text += table_of((*flow_statements(flow), *gyratory_statements(gyratory, pressed)))
    steel = """
| quantity | elastic | rigid | difference | +- |
|---|---:|---:|---:|---:|
"""
    text += f"""
## What the steel changes

SMA 11, 150 degC, 6.6 %: elastic mould and head against rigid ones, paired by seed.
{steel}"""
    text += "".join(steel_rows(options.gyratory))
    configurations = """
| configuration | begins [mm] | lowest [mm] | end [mm] | pressure, second half [kPa] | broken |
|---|---:|---:|---:|---:|---:|
"""
    text += f"""
## The flow test, configuration by configuration

Uplift when the strip begins to press (1 kPa), at its lowest and at the end:
{configurations}"""
    text += "".join(flow_rows(flow))
    if options.small:
        small = mixes(options.small)
        text += f"""
The same with {sizes(small)}:
{configurations}"""
        text += "".join(flow_rows(small)) + table_of(flow_statements(small))
    if options.full:
        text += f"""
## Gyratory compaction at the paper's 5000 stones

Elastic steel, one gyration; {sizes(full)}:

| configuration | voids before [%] | decrease [%] | mould [kPa] | internal angle [deg] | broken |
|---|---:|---:|---:|---:|---:|
"""
        text += "".join(full_rows(full))
        text += f"\nThe steel at this size:\n{steel}" + "".join(steel_rows(options.full))
    (options.out / "paper.md").write_text(text)
    print(text)


if __name__ == "__main__":
    main()
