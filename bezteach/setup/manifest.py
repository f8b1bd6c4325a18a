"""What the user's folder remembers: the identity of every lesson as it was copied, in one hidden file.

Opening a notebook in JupyterLab is enough to have it written anew, in another layout and with facts about the kernel.
So a notebook's identity is that of its cells, and only what the user does to those counts as a change.
"""

import contextlib
import hashlib
import json
import re

from bezteach.setup.progress import Problem

MANIFEST = ".bezteach.json"
# What reading JSON, and looking into it for what should be there, may raise.
MALFORMED = (ValueError, KeyError, TypeError, AttributeError, RecursionError)


def identity(path):
    """Return the hash of what a file says: of a notebook its cells, of anything else its bytes."""
    try:
        content = path.read_bytes()
    except OSError as error:
        raise Problem(f"cannot read {path} ({error.strerror}): put it right, or choose another folder") from None
    if path.suffix == ".ipynb":
        # Whatever else it is, it is no notebook.
        with contextlib.suppress(*MALFORMED):
            content = _cells(content)
    return hashlib.sha256(content).hexdigest()


def _cells(content):
    """Return the cells of a notebook as canonical JSON, each text in one piece (files hold it as lines, too)."""
    cells = json.loads(content)["cells"]
    for cell in cells:
        cell["source"] = _joined(cell["source"])
        bundles = list(cell.get("attachments", {}).values())
        for output in cell.get("outputs", []):
            if "text" in output:
                output["text"] = _joined(output["text"])
            bundles.append(output.get("data", {}))
        for bundle in bundles:
            # In JSON a list is a value of its own.
            texts = [kind for kind in bundle if not re.fullmatch(r"application/(.*\+)?json", kind)]
            bundle.update({kind: _joined(bundle[kind]) for kind in texts})
    return json.dumps({"cells": cells}, sort_keys=True).encode()


def _joined(text):
    return "".join(text) if isinstance(text, list) else text


def read_manifest(folder):
    """Return {path: {"copied": identity, "told": identity}}; empty if the file is missing or is not what we write."""
    try:
        files = json.loads((folder / MANIFEST).read_text(encoding="utf-8"))["files"]
        if all(isinstance(hashes, dict) for hashes in files.values()):
            return files
    except FileNotFoundError:
        pass
    except OSError as error:
        raise Problem(f"cannot read {folder / MANIFEST} ({error.strerror}): delete it") from None
    except MALFORMED:
        pass
    return {}


def manifest_text(files):
    """Return what the file is to say."""
    note = "bezteach keeps here which lessons it copied, so that it never overwrites one you changed."
    return json.dumps({"note": note, "files": files}, indent=1, sort_keys=True) + "\n"
