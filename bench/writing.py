#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""What writing costs at default intervals: the share of the loop that output takes.

    bench/writing.py build/release/crumple

The square tube of examples/04 at two sizes of elements, without any *DATABASE card (100 frames, 1000 rows of each
history), alone and with what else may be asked for. Shares are best read where nothing else uses the disk.
"""
import argparse
import json
import pathlib
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
EXTRAS = {
    "frames and tables": [],
    "and d3plot": ["--d3plot"],
    "and restart files every 2000 cycles": ["--restart-every", "2000"],
    "and --trace-energy": ["--trace-energy"],
}


def deck(element_size):
    """The tube's deck without its *DATABASE cards."""
    script = ROOT / "examples/04_square_tube/make_square_tube.py"
    text = subprocess.run([sys.executable, script, "--element-size", str(element_size)], check=True, text=True,
                          capture_output=True).stdout
    kept, skipping = [], False
    for line in text.splitlines():
        if line.startswith("*"):
            skipping = line.startswith("*DATABASE")
        if not skipping:
            kept.append(line)
    return "\n".join(kept) + "\n"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", type=pathlib.Path)
    options = parser.parse_args()
    program = options.program.resolve()
    print(f"{'shells':>8} {'written':36} {'loop [s]':>9} {'output [s]':>10} {'share':>7}")
    with tempfile.TemporaryDirectory() as folder:
        for element_size in (5, 2.5):
            path = pathlib.Path(folder) / "tube.k"
            path.write_text(deck(element_size))
            for name, extra in EXTRAS.items():
                out = pathlib.Path(folder) / "out"
                subprocess.run([program, "run", path, "-o", out, "-q", "--precision", "mixed", *extra], check=True,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
                record = json.loads((out / "run.json").read_text())
                loop, output = record["loop_seconds"], record["timings"]["output"]
                print(f"{record['elements']['shells']:8} {name:36} {loop:9.2f} {output:10.3f} {output / loop:7.1%}",
                      flush=True)


if __name__ == "__main__":
    main()
