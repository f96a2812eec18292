"""The configurations of a study of the paper's mixes: what is measured of their runs, with its
scatter over the seeds, and how they compare."""
import numpy as np
from scipy.stats import t as students_t

from . import slope
from .errors import InputError
from .run import Run
from .study import as_word, why_stopped

MIXES = {"SMA 11": ("6.6", "7.8"), "AC 11": ("5.4", "6.6")}


class Mix:
    """The runs of one configuration that came to their end, a seed each, and why others stopped."""

    def __init__(self, folder, runs, name):
        self.name = name
        word = as_word(name)
        if word not in runs:
            raise InputError(f"{folder}: expected a study of the paper's mixes, found no run of "
                             f"\"{name}\" that came to its end; give what trade left of a "
                             "studies/paper_*.toml once it is over")
        self.runs = [Run(run) for run in runs[word]]
        self.stopped = why_stopped(folder, word)

    def values(self, of):
        return np.array([of(run) for run in self.runs])

    def curve(self, x, y, grid):
        return np.mean([np.interp(grid, run.columns[x], run.columns[y]) for run in self.runs],
                       axis=0)


def by_seed(mix, of):
    return {run.name: of(run) for run in mix.runs}


def paired(one, other, of):
    """The values of two configurations with the seeds that both have, by seed."""
    found = by_seed(one, of), by_seed(other, of)
    both = sorted(found[0].keys() & found[1].keys())
    return [{seed: values[seed] for seed in both} for values in found]


def difference(one, other, of):
    """Of two configurations, by seed."""
    minuend, subtrahend = paired(one, other, of)
    return {seed: value - subtrahend[seed] for seed, value in minuend.items()}


def name(mix, temperature, content):
    return f"{mix}, {temperature} degC, {content} %"


def mixes(folder, runs):
    """Of a study's runs, folders by setting."""
    return {(mix, t, k): Mix(folder, runs, name(mix, t, content)) for mix, contents in MIXES.items()
            for t in (150, 110) for k, content in enumerate(contents)}


def with_rigid_steel(folder, runs):
    """The one configuration of gyratory compaction that is run twice, and its key among the mixes."""
    return ("SMA 11", 150, 0), Mix(folder, runs, name("SMA 11", 150, "6.6") + ", rigid steel")


def stones_of(study):
    return next(iter(study.values())).runs[0].summary["stones"]


def box(study):
    """Length and width of a flow test's [m], none of gyrations."""
    scene = next(iter(study.values())).runs[0].scene().get("flow", {})
    return [scene[edge] for edge in ("length", "width") if edge in scene]


def bed_height(run):
    return run.summary["bed_height_m"]


def contact_force(run):
    """Mean of the normal forces of stones that press each other, at the end [N]."""
    forces = run.table("contacts")["normal_force"]
    return np.mean(forces[forces > 0])


def broken(run):
    return run.columns["fractured"][-1]


def sizes_of_broken(run):
    """Of each broken stone, the share of the run's stones that are smaller."""
    radius = run.table("stones")["radius"]
    smaller = np.argsort(np.argsort(radius)) / len(radius)
    return smaller[run.table("fractures")["stone"].astype(int)]


def stretch(run):
    """How far apart the shells of each contact are at the end, below zero where they overlap, in
    metres, and as a share of the two shells."""
    stones, contacts = run.table("stones"), run.table("contacts")
    one, other = (contacts[name].astype(int) for name in ("first", "second"))
    place = np.stack([stones[axis] for axis in "xyz"], axis=1)
    shells = 2 * stones["shell_thickness"][0]
    radii = stones["radius"][one] + stones["radius"][other]
    apart = np.linalg.norm(place[one] - place[other], axis=1) - radii - shells
    return apart, apart / shells


def of_all_runs(study, of):
    """What is found in each run, one after the other along the last axis."""
    return np.concatenate([of(run) for mix in study.values() for run in mix.runs], axis=-1)


def uplift(run):
    return 1e3 * run.columns["uplift"][-1]


def lowest(run):
    return 1e3 * np.min(run.columns["uplift"])


def uplift_at(run, share):
    """Of the strip's way [mm]."""
    way = run.columns["displacement"]
    return 1e3 * np.interp(share * way[-1], way, run.columns["uplift"])


def compression(run):
    """How far the bed sinks over the first quarter of the strip's way, behind where the strip begins
    to press [mm]: from there on its weight alone would not move it."""
    return sinking(run) - uplift_at(run, 0.25)


def late_rise(run):
    """Uplift over the second half of the strip's way [mm]."""
    return uplift(run) - uplift_at(run, 0.5)


def sinking(run):
    """Uplift when the strip begins to press with 1 kPa [mm], nan if it never does."""
    pressed = run.columns["pressure"] > 1e3
    return 1e3 * run.columns["uplift"][np.argmax(pressed)] if pressed.any() else np.nan


def late(run):
    """The rows of the second half of a strip's way."""
    return run.columns["displacement"] > 0.5 * run.columns["displacement"][-1]


def pressure(run):
    return 1e-3 * np.mean(run.columns["pressure"][late(run)])


def roughness(run):
    """Of the pressure about a smooth curve, a cubic, root mean square [% of its mean]."""
    way, felt = (run.columns[name][late(run)] for name in ("displacement", "pressure"))
    return 100 * np.std(felt - np.polyval(np.polyfit(way, felt, 3), way)) / np.mean(felt)


def per_decade(run):
    """Slope of the density over the logarithm of the gyrations after the first half, in %Gmm."""
    return slope.per_decade(run.columns["gyration"], -100 * run.columns["air_voids"], first=0.5)


def depth(flow):
    """That every strip has reached [m]."""
    return min(run.columns["displacement"][-1] for mix in flow.values() for run in mix.runs)


def turns(gyratory):
    """Gyrations that every run has done."""
    return min(run.columns["gyration"][-1] for mix in gyratory.values() for run in mix.runs)


def voids_before(run):
    return 100 * run.summary["air_voids_start"]


def decrease(run):
    """Of the air voids, at the end [% of volume]."""
    return 100 * run.columns["air_voids_decrease"][-1]


def internal_angle(run):
    """Mean of the gyrations [deg]."""
    return run.mean_gyrating("internal_angle")


def traction(run):
    """Of the mould, mean of the gyrations [kPa]."""
    return 1e-3 * run.mean_gyrating("mould_traction")


def spread(values):
    """Their mean and its standard error, nan of a single one."""
    error = np.std(values, ddof=1) / np.sqrt(len(values)) if len(values) > 1 else np.nan
    return np.mean(values), error


def sure(values):
    """Their mean, and what it is off by in 1 of 20 cases (Student), nan of a single one."""
    value, error = spread(values)
    return value, error * students_t.ppf(0.975, max(len(values) - 1, 1))


def over_seeds(rows):
    """Mean of rows of values by seed, and how sure: a seed counts as one, since its runs begin with
    the same places; where a row lacks it, that row's other seeds stand for it. Without a value: nan."""
    rows = [{seed: value for seed, value in row.items() if np.isfinite(value)} for row in rows]
    middles = [np.mean(list(row.values())) for row in rows if row]
    rows = [row for row in rows if row]
    apart = [np.mean([row[seed] - middle for row, middle in zip(rows, middles) if seed in row])
             for seed in sorted(set().union(*rows))]
    return (np.mean(middles), sure(apart)[1]) if rows else (np.nan, np.nan)


def mean(runs_of, of):
    """Over the configurations, and how sure."""
    return over_seeds([by_seed(mix, of) for mix in runs_of.values()])


def compare(runs_of, of, place, more, less, unit):
    """Words on the configurations that have `more` at a place of their key against those alike but
    for `less` there, paired by seed: is the first really larger?"""
    pairs = [(runs_of[key], runs_of[key[:place] + (less,) + key[place + 1:]])
             for key in runs_of if key[place] == more]
    one, other = (over_seeds([paired(*pair, of)[side] for pair in pairs])[0] for side in (0, 1))
    apart, error = over_seeds([difference(*pair, of) for pair in pairs])
    verdict = "agrees" if apart > error else "against" if apart < -error else "not told apart"
    return (f"{one:.4g} against {other:.4g} {unit}, apart by {apart:.3g} (+-{error:.3g})", verdict)


def told(mix, of, digits):
    value, error = spread(mix.values(of))
    return f"{value:{digits}}" + (f" +- {error:{digits}}" if np.isfinite(error) else "")
