"""The command ``python tests/benchmarks``. One thread is all that BLAS gets, which it must know before NumPy loads."""

import os
import sys
from pathlib import Path

for name in ("OPENBLAS", "MKL", "OMP", "BLIS"):
    os.environ[f"{name}_NUM_THREADS"] = "1"
os.environ.setdefault("SYMPY_GROUND_TYPES", "python")  # what python-flint buys has rows of its own
sys.path[0] = str(Path(__file__).parents[1])

from benchmarks.command import main  # noqa: E402

sys.exit(main())
