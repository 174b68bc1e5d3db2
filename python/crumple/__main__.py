# SPDX-License-Identifier: BSD-3-Clause
"""`python3 -m crumple run deck.k ...`: the program, from the package. What it prints comes at its end."""
import sys

from . import _crumple

code, out, error = _crumple.run_program(sys.argv[1:])
sys.stdout.buffer.write(out)
sys.stdout.flush()
sys.stderr.buffer.write(error)
sys.exit(code)
