#!/usr/bin/env python3
"""Every TOML file that is shipped is one for other readers, too: Python's tomllib (TOML 1.0.0).

usage: toml_files_test.py ROOT_OF_THE_PROJECT
exit code 77: this Python is older than 3.11
"""
import pathlib
import sys

try:
    import tomllib
except ImportError:
    print("left out: this Python has no tomllib")
    sys.exit(77)

root = pathlib.Path(sys.argv[1])
# Those of the folders that a package or a release has; what tests make wrong on purpose lies in none of them.
files = sorted(file for folder in ("config", "docs", "programs", "python", "packaging") for file in (root / folder).rglob("*.toml"))
faults = 0
for file in files:
    try:
        tomllib.loads(file.read_text(encoding="utf-8"))
    except tomllib.TOMLDecodeError as fault:
        print(f"{file.relative_to(root)}: {fault}")
        faults += 1
print(f"{len(files)} files, {faults} that other readers refuse")
sys.exit(1 if faults or not files else 0)
