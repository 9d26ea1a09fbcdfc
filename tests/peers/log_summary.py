#!/usr/bin/env python3
"""Reads an LCM log by the published format and counts what is in it.

Independent of our own reader and writer: only the event header of LCM (big endian: sync word,
event number, time, lengths) and the first four fields of our messages (fingerprint, utime, cycle,
seq) are known here. A gap is a sequence number that is missing between two of one channel.

usage: log_summary.py FILE [WORD]     only channels whose name contains WORD
prints "NAME messages M gaps G" for every channel, then the sums
"""

import struct
import sys

SYNC_WORD = 0xEDA1DA01
EVENT_HEADER = struct.Struct(">Iqqii")
MESSAGE_HEADER = struct.Struct(">Qqqq")


def events(file):
    """Channel name and data of every complete event."""
    while len(header := file.read(EVENT_HEADER.size)) == EVENT_HEADER.size:
        sync, _, _, name_bytes, data_bytes = EVENT_HEADER.unpack(header)
        if sync != SYNC_WORD:
            sys.exit(f"no event at byte {file.tell() - len(header)}")
        name, data = file.read(name_bytes), file.read(data_bytes)
        if len(data) == data_bytes:
            yield name.decode(), data


def main():
    word = sys.argv[2] if len(sys.argv) > 2 else ""
    messages, gaps, last = {}, {}, {}
    with open(sys.argv[1], "rb") as file:
        for name, data in events(file):
            if word not in name or len(data) < MESSAGE_HEADER.size:
                continue
            seq = MESSAGE_HEADER.unpack_from(data)[3]
            missing = seq - last[name] - 1 if name in last else 0
            gaps[name] = gaps.get(name, 0) + missing
            messages[name] = messages.get(name, 0) + 1
            last[name] = seq
    for name in sorted(messages):
        print(f"{name} messages {messages[name]} gaps {gaps[name]}")
    print(f"sum messages {sum(messages.values())} gaps {sum(gaps.values())}")


main()
