"""What a folder holds that somebody gives to a program here."""
from .errors import InputError

RUN, STUDY, TABLES = "the folder of a run", "the folder of a study", "a folder of tables (.csv)"
NEW_RUN, OTHER = "a run without results yet", "another folder"
FILE, ABSENT = "a file", "no such folder"

ADVICE = {RUN: "plot_run.py draws it",
          STUDY: "give one of its runs, runs/SETTING/seed_N",
          TABLES: "stress_maps.py draws those of wall_stress, plot_path.py those of contact_path",
          NEW_RUN: "wait for its first results, or plot_run.py --live does so",
          OTHER: "give what a program left in --out",
          FILE: "give the folder that it lies in",
          ABSENT: "correct the path"}


def kind_of(folder):
    if not folder.is_dir():
        return FILE if folder.exists() else ABSENT
    if (folder / "results.h5").exists():
        return RUN
    if (folder / "study.h5").exists() or any(folder.glob("runs/*/seed_*")):
        return STUDY
    if (folder / "scene.toml").exists():
        return NEW_RUN
    return TABLES if any(folder.glob("*.csv")) else OTHER


def expect(folder, *kinds):
    """The one of the kinds that it is."""
    found = kind_of(folder)
    if found not in kinds:
        raise InputError(f"{folder}: expected {' or '.join(kinds)}, found {found}; {ADVICE[found]}")
    return found
