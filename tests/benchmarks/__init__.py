"""Speed and accuracy of bezteach, measured against every peer: ``python tests/benchmarks`` prints the table.

- ``job``: what is timed, and its bar; ``measuring`` checks and times it, ``report`` prints it
- ``peers``: the other libraries; each is tried once
- ``evaluation``, ``parts``, ``bsplines``, ``exact``, ``accuracy``, ``growth``, ``clock``: the jobs, subject by subject
"""
