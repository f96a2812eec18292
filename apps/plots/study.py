"""What trade left in the folder of a study: runs/SETTING/seed_N, and study.h5, which it writes anew
whenever all runs are over."""
import contextlib
import sys

import h5py

from .errors import InputError, reading
from .folders import STUDY, expect


WRITTEN = "which trade writes when all runs are over"


def as_word(name):
    """The name of a setting as part of a path, as apps/study.h has it."""
    return "".join(c if c.isalnum() or c in ".-" else "_" for c in name.replace(",", ""))


@contextlib.contextmanager
def results(folder):
    """study.h5 of a study that came to its end."""
    expect(folder, STUDY)
    path = folder / "study.h5"
    if not path.exists():
        raise InputError(f"{path}: expected the results of a study, found none yet, as its runs "
                         f"are not over; go on by trade STUDY.toml --out {folder}")
    with reading(path, "the results of a study", "run trade again"), h5py.File(path) as file:
        yield file


def runs_of(seeds):
    """The names of their folders."""
    return {f"seed_{seed:.0f}" for seed in seeds}


def runs_by_setting(folder):
    """Folders of the runs that came to their end, by the word of their setting; if study.h5 is
    there, those that it is made of. Says which are left out."""
    expect(folder, STUDY)
    known = None
    if (folder / "study.h5").exists():
        with results(folder) as file:
            known = {word: runs_of(group["seeds"])
                     for word, group in file.get("settings", {}).items()}
    found, unknown = {}, {}
    for run in sorted(path for path in folder.glob("runs/*/seed_*") if path.is_dir()):
        word = run.parent.name
        if known is not None and word not in known:
            unknown[word] = run.parent
        elif not (run / "summary.json").exists():
            print(f"{run}: left out, not at its end", file=sys.stderr)
        elif known is not None and run.name not in known[word]:
            print(f"{run}: left out, no seed of study.h5, {WRITTEN}", file=sys.stderr)
        else:
            found.setdefault(word, []).append(run)
    for setting in unknown.values():
        print(f"{setting}: left out, no setting of study.h5, {WRITTEN}", file=sys.stderr)
    return found


def why_stopped(folder, word):
    """What the runs of a setting stopped by, by seed_N, of the seeds of study.h5, if that is there."""
    stopped = sorted((folder / "runs" / word).glob("seed_*.stopped"))
    if (folder / "study.h5").exists():
        with results(folder) as file:
            known = runs_of(file["study/seeds"])
        stopped = [path for path in stopped if path.stem in known]
    return {path.stem: path.read_text() for path in stopped}
