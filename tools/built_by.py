# SPDX-License-Identifier: BSD-3-Clause
"""Which compiler made a program."""

import re
import subprocess


def compiler_in(comment):
    """'g++ 12.2.0' from the text of a .comment section; start-up files of the system are g++'s in any case."""
    clang = re.search(r"clang version (\d[\d.]*)", comment)
    if clang:
        return f"clang++ {clang.group(1)}"
    gcc = re.findall(r"GCC: \([^)]*\) (\d[\d.]*)", comment)
    return f"g++ {gcc[-1]}" if gcc else "an unknown compiler"


def compiler_of(program):
    """The same of a program's file, by readelf of the binutils."""
    section = subprocess.run(["readelf", "-p", ".comment", program], check=True, text=True, stdout=subprocess.PIPE)
    return compiler_in(section.stdout)
