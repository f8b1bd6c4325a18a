"""Trust for the copied lessons: Jupyter shows stored pictures only of notebooks that it knows to be the user's."""


def sign(paths):
    """Sign notebooks as ours; return "" or why it failed.

    Needs nbformat. Never raises: an unsigned lesson lacks some pictures until a cell is run, no more.
    """
    if not paths:
        return ""
    try:
        import logging

        import nbformat
        from nbformat.sign import NotebookNotary

        # Of several lines about the database one of ours is enough.
        logging.disable()
        try:
            notary = NotebookNotary()
            try:
                for path in paths:
                    notary.sign(nbformat.read(path, as_version=4))
                # If the database on the disk does not work the notary takes one in memory, without an error.
                lost = getattr(notary.store, "db_file", None) == ":memory:" != notary.db_file
            finally:
                notary.store.close()
        finally:
            logging.disable(logging.NOTSET)
    except Exception as error:  # nothing that happens here is worth losing the lab
        return " ".join(str(error).split())[:200] or type(error).__name__
    return "the database of signatures cannot be written" if lost else ""
