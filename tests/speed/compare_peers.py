"""Times dem_speed and other DEM codes in turn (A B A B) and prints one line per comparison.

Read the table by its ratios: a rival and ours run one after the other on the same machine, and the
median is that of the ratios of such neighbours. Debian's builds of the peers use no AVX; --plain adds
our own time without it."""
import argparse
import json
import os
import shutil
import statistics
import subprocess
import sys
import tempfile

HOUSE = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAMS = {"lammps_hist": "lmp", "lammps_granular": "lmp", "liggghts": "liggghts", "yade": "yade"}
FASTER_THAN = {"lammps_hist": 5.0}  # the others are shown without a target
QUICK_STEPS = {5000: (1000, 800)}   # before the clock starts, timed
SPEEDUP_OF_TWO_THREADS = {5000: 1.6, 50000: 1.8}
ASPHALT_TO_DRY = 2.0                # time per touching contact
BYTES_PER_STONE = {"dry": 1200, "asphalt": 2500}
LISTS_OF_GYRATING_BED = 0.10        # of the step
STEEL_OF_ELASTIC_RUN = 0.05         # of the step, default modes
ELASTIC = ["gyration.ramp=0.1 s", "gyration.dwell=0.1 s", "gyration.count=0.05",
           "output.picture_interval=0 s"]
LARGE_TO_SMALL = 1.5                # time per stone and step, 200,000 stones to 5000
GYRATING = ["--gyrate", "10"]       # 10^5 steps a gyration, as in a paper-size run
GYRATING_STEPS = (12000, 4000)      # until the lid is down, timed
# Our threads wait as the processes of MPI do: they spin.
ENVIRONMENT = dict(os.environ, OMP_WAIT_POLICY="active")


def arguments():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--full", action="store_true", help="every installed peer and both beds")
    parser.add_argument("--peers", default=os.path.join(os.path.dirname(HOUSE), "shared", "peers"))
    parser.add_argument("--program", default=os.path.join(HOUSE, "build", "bin", "dem_speed"))
    plain = os.path.join(HOUSE, "build_portable", "bin", "dem_speed")
    parser.add_argument("--plain", default=plain if os.access(plain, os.X_OK) else None,
                        help="dem_speed built for any x86-64, to show beside it; that of the preset "
                        "portable if it is built")
    parser.add_argument("--repeats", type=int, default=3)
    options = parser.parse_args()
    if not os.path.isfile(os.path.join(options.peers, "run_bench.py")):
        parser.error(f"no run_bench.py in {options.peers}; name the folder with --peers")
    if not os.access(options.program, os.X_OK):
        parser.error(f"no program at {options.program}; build it, or name it with --program")
    return options


class Table:
    """Prints a line at a time and remembers whether all targets hold."""

    layout = "{:<34} {:>7} {:>5}  {:>10} {:>10} {:>7}  {:>8}  {}"

    def __init__(self):
        self.holds = True
        print(self.layout.format("comparison", "stones", "cores", "ours", "theirs", "ratio",
                                 "target", "holds"))

    def line(self, name, stones, cores, ours, theirs, ratio, least=None, most=None):
        holds = (least is None or ratio >= least) and (most is None or ratio <= most)
        self.holds &= holds
        target = f">= {least:g}" if least else f"<= {most:g}" if most else "-"
        verdict = ("yes" if holds else "NO") if least or most else "-"
        show = lambda value: "-" if value is None else f"{value:.4g}"
        print(self.layout.format(name, stones, cores, show(ours), show(theirs), f"{ratio:.2f}",
                                 target, verdict), flush=True)


class Beds:
    """Runs ours and the peers' codes on the shared beds."""

    def __init__(self, options, folder):
        sys.path.insert(0, options.peers)
        import beds
        import run_bench
        self.options, self.folder = options, folder
        self.bench, self.beds = run_bench, beds

    def steps(self, code, stones):
        if not self.options.full:
            return QUICK_STEPS[stones]
        return self.bench.STEPS[code][stones]

    def bed(self, stones):
        return os.path.join(self.options.peers, "beds", f"bed_{stones}.csv")

    def ours(self, law, stones, cores, steps, program=None, bed=None, more=()):
        command = [program or self.options.program, "--law", law, "--threads", str(cores), "--json",
                   "--bed", bed or self.bed(stones), *more,
                   "--warmup", str(steps[0]), "--steps", str(steps[1])]
        done = subprocess.run(command, capture_output=True, text=True, env=ENVIRONMENT)
        if done.returncode:
            sys.exit("failed: " + " ".join(command) + "\n" + done.stderr)
        return json.loads(done.stdout)

    def stacked(self, stones, copies):
        """A bed of so many copies of another one, each on top of the one before."""
        position, radius = self.beds.read_bed(self.bed(stones))
        height = (position[:, 2] + radius).max()
        path = f"{self.folder}/stacked.csv"
        with open(path, "w") as file:
            print(f"# cylinder_radius={self.beds.cyl_radius(stones)}", file=file)
            for copy in range(copies):
                for (x, y, z), r in zip(position, radius):
                    print(f"{x:.12g},{y:.12g},{z + copy * height:.12g},{r:.12g}", file=file)
        return path

    def write_data(self, stones):
        position, radius = self.beds.read_bed(self.bed(stones))
        self.beds.write_data(f"{self.folder}/data_{stones}", position, radius,
                             self.beds.cyl_radius(stones), "lammps")

    def theirs(self, code, stones, cores, steps):
        run = self.bench.one(code, stones, cores, self.bench.BEST[code], *steps, self.folder)
        return 1e3 * run["wall"] / run["steps"]


def compare_with_peer(beds, table, code, stones, cores):
    steps = beds.steps(code, stones)
    ours, theirs = [], []
    for _ in range(beds.options.repeats):
        ours.append(beds.ours("dry", stones, cores, steps)["ms_per_step"])
        theirs.append(beds.theirs(code, stones, cores, steps))
    ratio = statistics.median(b / a for a, b in zip(ours, theirs))
    table.line(f"{code} [ms/step]", stones, cores, statistics.median(ours),
               statistics.median(theirs), ratio, least=FASTER_THAN.get(code))


def compare_with_self(beds, table, stones):
    """The targets that need no peer."""
    steps = beds.steps("lammps_hist", stones)
    rounds = [{name: beds.ours(law, stones, cores, steps)
               for name, law, cores in (("one", "dry", 1), ("two", "dry", 2), ("asphalt", "asphalt", 1))}
              for _ in range(beds.options.repeats)]

    def per_contact(run):
        return 1e9 / run["contact_steps_per_s"]

    def medians(a, b):
        values = [(a(round), b(round)) for round in rounds]
        return [statistics.median(column) for column in zip(*((x, y, y / x) for x, y in values))]

    one, two, gain = medians(lambda r: r["two"]["ms_per_step"], lambda r: r["one"]["ms_per_step"])
    table.line("two threads for one [ms/step]", stones, 2, one, two, gain,
               least=SPEEDUP_OF_TWO_THREADS[stones])
    dry, asphalt, ratio = medians(lambda r: per_contact(r["one"]), lambda r: per_contact(r["asphalt"]))
    table.line("asphalt for dry [ns/contact]", stones, 1, asphalt, dry, ratio, most=ASPHALT_TO_DRY)
    for law, run in (("dry", rounds[0]["one"]), ("asphalt", rounds[0]["asphalt"])):
        table.line(f"{law} memory [B/stone]", stones, 1, run["bytes_per_stone"], BYTES_PER_STONE[law],
                   run["bytes_per_stone"] / BYTES_PER_STONE[law], most=1.0)


def compare_builds(beds, table, stones):
    """Ours for any x86-64 against ours for this machine."""
    steps = beds.steps("lammps_hist", stones)
    native, plain = [], []
    for _ in range(beds.options.repeats):
        native.append(beds.ours("dry", stones, 1, steps)["ms_per_step"])
        plain.append(beds.ours("dry", stones, 1, steps, beds.options.plain)["ms_per_step"])
    ratio = statistics.median(b / a for a, b in zip(native, plain))
    table.line("ours without AVX [ms/step]", stones, 1, statistics.median(native),
               statistics.median(plain), ratio)


def compare_gyrating(beds, table, stones):
    """The lists of a bed that moves."""
    run = beds.ours("dry", stones, 1, GYRATING_STEPS, more=GYRATING)
    share = run["share"]["lists"]
    table.line("lists of a gyrating bed [share]", stones, 1, share, LISTS_OF_GYRATING_BED,
               share / LISTS_OF_GYRATING_BED, most=1.0)


def compare_elastic(beds, table):
    """What a mould and a head of steel take of a run of 5000 stones."""
    program = os.path.join(os.path.dirname(beds.options.program), "gyratory")
    scene = os.path.join(HOUSE, "apps", "scenes", "gyratory_sma11_150C_paper_steel.toml")
    out = f"{beds.folder}/elastic"
    command = [program, scene, "--out", out, "--threads", "1", "--quiet"]
    command += [word for override in ELASTIC for word in ("--set", override)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        sys.exit("failed: " + " ".join(command) + "\n" + done.stderr)
    with open(f"{out}/summary.json") as file:
        spent = json.load(file)
    share = spent["seconds_steel"] / sum(spent[f"seconds_{part}"]
                                         for part in ("stones", "outputs", "steel"))
    table.line("elastic steel [share]", 5000, 1, share, STEEL_OF_ELASTIC_RUN,
               share / STEEL_OF_ELASTIC_RUN, most=1.0)


def compare_sizes(beds, table):
    """Time per stone and step of a large bed: four of the middle size, one on top of the other."""
    large = beds.stacked(50000, 4)

    def per_stone(run):
        return 1e9 / run["particle_steps_per_s"]

    rounds = [(per_stone(beds.ours("dry", 200000, 1, (200, 100), bed=large)),
               per_stone(beds.ours("dry", 5000, 1, (1000, 800))))
              for _ in range(beds.options.repeats)]
    ours, small = (statistics.median(column) for column in zip(*rounds))
    table.line("200,000 stones for 5000 [ns/stone]", 200000, 1, ours, small,
               statistics.median(a / b for a, b in rounds), most=LARGE_TO_SMALL)


def main():
    options = arguments()
    wanted = PROGRAMS if options.full else ["lammps_hist"]
    codes = [code for code in wanted if shutil.which(PROGRAMS[code])]
    for code in wanted:
        if code not in codes:
            print(f"{code}: {PROGRAMS[code]} is not installed, left out")
    table = Table()
    with tempfile.TemporaryDirectory() as folder:
        beds = Beds(options, folder)
        for stones in (5000, 50000) if options.full else (5000,):
            beds.write_data(stones)
            for code in codes:
                for cores in (1, 2):
                    compare_with_peer(beds, table, code, stones, cores)
            if options.plain:
                compare_builds(beds, table, stones)
            compare_with_self(beds, table, stones)
        if options.full:
            compare_gyrating(beds, table, 5000)
            compare_elastic(beds, table)
            compare_sizes(beds, table)
    sys.exit(0 if table.holds and codes else 1)


if __name__ == "__main__":
    main()
