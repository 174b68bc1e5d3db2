# SPDX-License-Identifier: BSD-3-Clause
"""Generator of a small car of folded sheet panels for crash runs. Units: kg, mm, ms (forces in kN, stresses in GPa)."""
