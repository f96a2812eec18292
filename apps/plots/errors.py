"""How the programs for pictures end badly: with one line on stderr, and the exit status that
apps/errors.h has for it."""
import contextlib
import sys
import textwrap

OK, BAD_INPUT, OUTPUT_TROUBLE, INTERRUPTED = 0, 2, 4, 130


class InputError(Exception):
    """A mistake of the user: `what: expected ..., found ..., what to do`."""


@contextlib.contextmanager
def reading(path, expected, advice):
    """A file that cannot be read inside is a mistake of the user."""
    try:
        yield
    except InputError:
        raise
    except Exception as trouble:  # h5py and numpy answer damage by nearly all of them
        found = {FileNotFoundError: "no such file", IsADirectoryError: "a folder"}.get(
            type(trouble), f"a damaged or another file ({textwrap.shorten(str(trouble), 120)})")
        raise InputError(f"{path}: expected {expected}, found {found}; {advice}") from trouble


def exit_status_of(main):
    try:
        main()
    except InputError as mistake:
        print(mistake, file=sys.stderr)
        return BAD_INPUT
    except OSError as trouble:  # whatever is read tells of itself
        print(f"{trouble.filename or 'stdout'}: cannot be written: {trouble.strerror or trouble}",
              file=sys.stderr)
        return OUTPUT_TROUBLE
    except KeyboardInterrupt:
        return INTERRUPTED
    return OK
