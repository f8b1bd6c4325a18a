"""Files and folders that are whole or not there, however the writing ends."""

import contextlib
import os


def write(path, content):
    """Write a file: beside it first, then in one move."""
    draft = path.with_name(f".bezteach-{os.getpid()}.part")
    try:
        draft.write_bytes(content)
        os.replace(draft, path)
    finally:
        with contextlib.suppress(OSError):
            draft.unlink(missing_ok=True)


@contextlib.contextmanager
def removed_if_empty(folder):
    """If the block fails, remove the folder and those above it, as far as the block made them and they are empty."""
    new = [place for place in (folder, *folder.parents) if not os.path.lexists(place)]
    try:
        yield
    except BaseException:
        for place in new:
            with contextlib.suppress(OSError):
                place.rmdir()
        raise
