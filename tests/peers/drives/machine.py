#!/usr/bin/env python3
"""Writes the machine whose drives are the worked examples of docs/integrator/drives.md.

usage: machine.py DRIVES.md FOLDER      writes FOLDER/machine.toml
"""

import pathlib
import re
import sys

HEAD = """[machine]
name = "examples"

[[channel]]
id = 1
name = "work"
axes = ["X", "Y"]
spindles = [1]

"""


def main():
    document = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8")
    text = HEAD + "\n".join(re.findall(r"```toml\n(.*?)```", document, re.DOTALL))
    text = text.replace('host = "192.168.10.2"', 'host = "127.0.0.1"\nport = 0')
    (pathlib.Path(sys.argv[2]) / "machine.toml").write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
