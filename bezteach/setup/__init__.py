"""What happens between ``python3 -m bezteach`` and the command: setting up, the user's folder, starting JupyterLab.

It runs before anything is installed, so no module here imports more than the standard library when it is loaded.

- ``processes``: child processes that can always be ended, and becoming another one
- ``progress``: what the user is told while a command runs, and why one failed; ``Problem``
- ``requirements``: what a command needs, and what of it is lacking
- ``locking``: one set-up of a checkout at a time
- ``virtualenv``: the ``.venv`` of a checkout, made or completed, and the command started again inside it
- ``manifest``: what the user's folder remembers of the lessons copied into it
- ``testing``: pytest, with Ctrl-C in order from its first moment
- ``workspace``: the lessons in the user's folder, without ever touching what the user changed
- ``writing``: files and folders that are whole or not there
- ``signing``: trust for the copied lessons, so that their stored pictures show
- ``lab``: JupyterLab in the user's folder; ``labconfig`` holds our defaults for it
"""
