#!/usr/bin/env python3
"""Draws the folders of the project and what each may include, from the build files.

usage: draw-folders.py [--check]

Writes docs/developer/pictures/folders.svg. Arrows are the DEPENDS of the stanok_library lines of the top
CMakeLists.txt between folders of the top level, without those that follow from others. Exit code 1 with --check
where the picture is not that of the build files, and where two folders include each other in a circle.
"""

import argparse
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
PICTURE = ROOT / "docs/developer/pictures/folders.svg"

WINGS = {
    "machine": ["base", "lang", "kinematics", "motion", "process", "channels"],
    "shop": ["drives", "plant", "config", "simulation", "recording", "messages", "runtime", "jobs"],
    "doors": ["protocol", "daemon", "client", "web", "panel", "gateway", "opcua", "python"],
}
BESIDE = {
    "to read": ["programs", "posts", "docs"],
    "to build and test": ["tests", "benchmarks", "tools", "cmake", "packaging"],
}
# Doors that are no C++ library: what they hold on to.
OTHER_EDGES = {"panel": ["protocol"], "opcua": ["protocol"], "python": ["jobs"]}
WHAT = {
    "base": "units, catalogue, rings", "lang": "programs to commands", "kinematics": "axes from points",
    "motion": "path and speed", "process": "science of the cut", "channels": "run, queue, cycle",
    "drives": "Modbus", "plant": "simulated drives", "config": "machine files", "simulation": "virtual workpiece",
    "recording": "LCM logs", "messages": "LCM types", "runtime": "assembly, replay", "jobs": "check, forecast, identify",
    "protocol": "methods, connection", "daemon": "stanokd", "client": "stanok", "web": "stanok-web",
    "panel": "the page", "gateway": "MQTT, history", "opcua": "OPC UA server", "python": "Python package",
}


def edges_of(text):
    """Folder of the top level -> those that it may include."""
    text = re.sub(r"#.*", "", text)
    found = {}
    for line in re.findall(r"stanok_library\(([^)]*)\)", text):
        words = line.split()
        folder = words[0].split("/")[0]
        into = found.setdefault(folder, set())
        if "DEPENDS" not in words:
            continue
        for word in words[words.index("DEPENDS") + 1:]:
            if word.isupper():
                break
            into.add(word.split("/")[0])
        into.discard(folder)
    for folder, into in OTHER_EDGES.items():
        found.setdefault(folder, set()).update(into)
    return found


def circle_in(edges):
    """A list of folders that leads back to its first one; empty: there is none."""
    done = set()

    def visit(folder, way):
        if folder in way:
            return way[way.index(folder):] + [folder]
        if folder in done:
            return []
        for below in sorted(edges.get(folder, ())):
            circle = visit(below, [*way, folder])
            if circle:
                return circle
        done.add(folder)
        return []

    for folder in sorted(edges):
        circle = visit(folder, [])
        if circle:
            return circle
    return []


def reach(edges, folder, known):
    if folder not in known:
        known[folder] = set()
        for below in edges.get(folder, ()):
            known[folder] |= {below} | reach(edges, below, known)
    return known[folder]


def reduced(edges):
    """Without what follows from others."""
    known = {}
    return {
        folder: {below for below in into if not any(below in reach(edges, other, known) for other in into - {below})}
        for folder, into in edges.items()
    }


def levels(edges):
    known = {}

    def level(folder):
        if folder not in known:
            known[folder] = 1 + max((level(below) for below in edges.get(folder, ())), default=-1)
        return known[folder]

    return {folder: level(folder) for wing in WINGS.values() for folder in wing}


WIDTH, BOX_W, BOX_H, ROW, COLUMN, TOP = 1180, 150, 44, 86, 380, 56


# Folder -> left top corner and width; rows by level, wings side by side.
def places(level):
    rows = sorted({*level.values()}, reverse=True)
    y_of = {one: TOP + 20 + ROW * k for k, one in enumerate(rows)}
    found = {}
    for wing, folders in enumerate(WINGS.values()):
        for row in rows:
            here = [folder for folder in folders if level[folder] == row]
            gap = 10
            wide = min(BOX_W, (COLUMN - 40 - gap * (len(here) - 1)) / max(1, len(here)))
            width = len(here) * wide + (len(here) - 1) * gap
            left = 20 + wing * COLUMN + (COLUMN - 20 - width) / 2
            for k, folder in enumerate(here):
                found[folder] = (left + k * (wide + gap), y_of[row], wide)
    return found, max(y_of.values()) + BOX_H + 20


def box(folder, x, y, wide):
    return (
        f'<rect x="{x:.0f}" y="{y:.0f}" width="{wide:.0f}" height="{BOX_H}" rx="5" fill="#ffffff" stroke="#7d8a94"/>'
        f'<text x="{x + wide / 2:.0f}" y="{y + 19:.0f}" class="name">{folder}</text>'
        f'<text x="{x + wide / 2:.0f}" y="{y + 35:.0f}" class="what">{WHAT[folder]}</text>\n'
    )


def arrow(start, end):
    (x0, y0, wide0), (x1, y1, wide1) = start, end
    x0, y0, x1 = x0 + wide0 / 2, y0 + BOX_H, x1 + wide1 / 2
    bend = (y1 - y0) * 0.5
    return (
        f'<path d="M{x0:.0f},{y0:.0f} C{x0:.0f},{y0 + bend:.0f} {x1:.0f},{y1 - bend:.0f} {x1:.0f},{y1 - 2:.0f}" '
        'class="edge"/>\n'
    )


def drawing(edges):
    level = levels(edges)
    place, bottom = places(level)
    height = bottom + 84
    text = (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {height:.0f}" role="img" '
        'aria-label="Folders of the project and what each may include">\n'
        "<style>text{font-family:sans-serif;fill:#24292e}.wing{font-size:17px;font-weight:600}"
        ".name{font-size:14px;font-weight:600;text-anchor:middle}.what{font-size:11px;fill:#57606a;text-anchor:middle}"
        ".edge{fill:none;stroke:#8fa1ae;stroke-width:1.2;marker-end:url(#head)}</style>\n"
        '<defs><marker id="head" viewBox="0 0 8 8" refX="7" refY="4" markerWidth="7" markerHeight="7" orient="auto">'
        '<path d="M0,0 L8,4 L0,8 z" fill="#8fa1ae"/></marker></defs>\n'
        f'<rect width="{WIDTH}" height="{height:.0f}" fill="#ffffff"/>\n'
    )
    for k, wing in enumerate(WINGS):
        left = 20 + k * COLUMN
        text += (
            f'<rect x="{left}" y="16" width="{COLUMN - 20}" height="{bottom - 16:.0f}" rx="8" fill="#f3f6f8"/>'
            f'<text x="{left + 14}" y="42" class="wing">{wing}</text>\n'
        )
    for folder, into in sorted(reduced(edges).items()):
        for below in sorted(into):
            if folder in place and below in place:
                text += arrow(place[folder], place[below])
    for folder, (x, y, wide) in sorted(place.items()):
        text += box(folder, x, y, wide)
    left = 20
    for wing, folders in BESIDE.items():
        width = 380 - 20 if wing == "to read" else 740
        text += (
            f'<rect x="{left}" y="{bottom + 14:.0f}" width="{width}" height="54" rx="8" fill="#f3f6f8"/>'
            f'<text x="{left + 14}" y="{bottom + 47:.0f}" class="wing">{wing}: '
            f'<tspan font-weight="400">{", ".join(folders)}</tspan></text>\n'
        )
        left += width + 20
    return text + "</svg>\n"


def folders_of_the_project():
    """Those of the top level with files under version control; what a build leaves there is none."""
    listed = subprocess.run(["git", "-C", str(ROOT), "ls-files"], capture_output=True, text=True, check=False)
    return {line.split("/")[0] for line in listed.stdout.splitlines() if "/" in line and not line.startswith(".")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true", help="write nothing; compare")
    options = parser.parse_args()
    edges = edges_of((ROOT / "CMakeLists.txt").read_text())
    circle = circle_in(edges)
    if circle:
        sys.exit("a circle of folders: " + " -> ".join(circle))
    known = {folder for wing in WINGS.values() for folder in wing}
    missing = sorted(set(edges) - known)
    if missing:
        sys.exit("in no wing of tools/draw-folders.py: " + ", ".join(missing))
    named = known | {folder for beside in BESIDE.values() for folder in beside}
    strangers = sorted(folders_of_the_project() - named)
    if strangers:
        sys.exit("folders in no wing of tools/draw-folders.py: " + ", ".join(strangers))
    text = drawing(edges)
    if options.check:
        if not PICTURE.exists() or PICTURE.read_text() != text:
            sys.exit(f"{PICTURE.relative_to(ROOT)} is not that of CMakeLists.txt; run tools/draw-folders.py")
        return
    PICTURE.parent.mkdir(parents=True, exist_ok=True)
    PICTURE.write_text(text)


if __name__ == "__main__":
    main()
