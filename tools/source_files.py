# SPDX-License-Identifier: BSD-3-Clause
"""What the checks share: the list of source files, the includes of a file, the layers' allow-list."""

import os
import re
import subprocess
from pathlib import Path

CPP_ENDINGS = (".hpp", ".cpp")
CPP_FOLDERS = ("cellsearch", "crumple", "tests", "bench", "examples")

INCLUDE = re.compile(r'^\s*#\s*include\s*(?:"([^"]+)"|<([^>]+)>|(\S+))')
COMMENT = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])*\'', re.S)


def repository_root():
    """Folder of the repository that this file belongs to."""
    return Path(__file__).resolve().parent.parent


def project_files(root):
    """All files of the project below root, relative to it and sorted: what git tracks or would track.
    Outside a git checkout (a release archive, a test's tree) all files but those of build folders."""
    if (root / ".git").exists():
        listing = subprocess.run(["git", "ls-files", "-z", "--cached", "--others", "--exclude-standard"],
                                 cwd=root, check=True, capture_output=True).stdout.decode()
        names = [Path(name) for name in listing.split("\0") if name]
    else:
        names = [path.relative_to(root) for path in root.rglob("*") if path.is_file()]
        names = [name for name in names if not name.parts[0].startswith(("build", "out", "."))]
    return sorted(name for name in set(names) if (root / name).is_file())


def cpp_files(root, folders=CPP_FOLDERS, endings=CPP_ENDINGS):
    """The C++ files below the given top folders."""
    return [name for name in project_files(root) if name.parts[0] in folders and name.suffix in endings]


def changed_since(root, commit):
    """The files that differ from a commit, relative to root; None if git does not know it."""
    listing = subprocess.run(["git", "diff", "--name-only", "--no-renames", commit, "--"], cwd=root,
                             capture_output=True, text=True)
    known = commit and listing.returncode == 0
    return {Path(name) for name in listing.stdout.split("\n") if name} if known else None


def without_comments(text):
    """The text with comments blanked; line numbers stay."""
    def blank(match):
        found = match.group(0)
        return found if found[0] in "\"'" else re.sub(r"[^\n]", " ", found)
    return COMMENT.sub(blank, text)


def includes(path):
    """(line number, kind, name) of every include; kind is 'quoted', 'angle' or 'computed'."""
    found = []
    for number, line in enumerate(without_comments(path.read_text(errors="replace")).split("\n"), 1):
        match = INCLUDE.match(line)
        if match:
            quoted, angle, computed = match.groups()
            kind = "quoted" if quoted else "angle" if angle else "computed"
            found.append((number, kind, quoted or angle or computed))
    return found


def include_folders(root):
    """Where the compilers look for the headers of the project."""
    return (root / "crumple", root / "cellsearch" / "include", root / "cellsearch" / "src", root / "tests",
            root / "cellsearch" / "tests", root / "cellsearch" / "bench")


def read_layers(root):
    """cmake/layers.cmake, the single source: ({folder: set of folders it may include}, set of folders
    outside the core)."""
    text = (root / "cmake" / "layers.cmake").read_text()
    block = re.search(r'set\(CRUMPLE_LAYERS\s+((?:"[^"]*"\s*)+)\)', text)
    if not block:
        raise SystemExit("cmake/layers.cmake: no set(CRUMPLE_LAYERS \"folder: allowed ...\" ...) found")
    layers = {}
    for line in re.findall(r'"([^"]*)"', block.group(1)):
        name, _, allowed = line.partition(":")
        layers[name.strip()] = set(allowed.split())
    outside = re.search(r"set\(CRUMPLE_NON_CORE\s+([^)]*)\)", text)
    return layers, set(outside.group(1).split()) if outside else set()


def read_rooms(root):
    """The rooms inside of folders, from cmake/layers.cmake: {room: set of rooms it may include}."""
    text = (root / "cmake" / "layers.cmake").read_text()
    block = re.search(r'set\(CRUMPLE_ROOMS\s+((?:"[^"]*"\s*)*)\)', text)
    rooms = {}
    for line in re.findall(r'"([^"]*)"', block.group(1)) if block else []:
        name, _, allowed = line.partition(":")
        rooms[name.strip()] = set(allowed.split())
    return rooms


def read_shared_headers(root):
    """Headers of a folder that all of its rooms may include, from cmake/layers.cmake."""
    block = re.search(r"set\(CRUMPLE_SHARED_HEADERS\s+([^)]*)\)", (root / "cmake" / "layers.cmake").read_text())
    return set(block.group(1).split()) if block else set()


def job_count():
    """Processors that this process may use."""
    return len(os.sched_getaffinity(0))
