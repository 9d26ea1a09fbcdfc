#!/usr/bin/env python3
"""Two pseudo terminals joined like the ends of a serial cable.

usage: cable.py ONE OTHER      links to the terminals are made at these paths; runs until killed
"""

import os
import pty
import select
import sys
import tty


def terminal(path):
    master, slave = pty.openpty()
    tty.setraw(slave)
    os.symlink(os.ttyname(slave), path)
    return master, slave


def main():
    one, _slave_of_one = terminal(sys.argv[1])
    other, _slave_of_other = terminal(sys.argv[2])
    partner = {one: other, other: one}
    while True:
        for ready in select.select([one, other], [], [])[0]:
            os.write(partner[ready], os.read(ready, 512))


if __name__ == "__main__":
    main()
