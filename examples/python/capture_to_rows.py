# The messages of a capture as rows: time, source, destination, message, field, value.
import argparse
import csv
import struct
import sys

import jauscat


# [rows]
def datagrams(path):
    """(time, payload) of each UDP datagram in a pcap file of Ethernet frames."""
    with open(path, "rb") as file:
        order = {b"\xd4\xc3\xb2\xa1": "<", b"\xa1\xb2\xc3\xd4": ">"}.get(file.read(24)[:4])
        if order is None:
            raise ValueError(f"{path} is no pcap file")
        while len(head := file.read(16)) == 16:
            seconds, microseconds, size, _ = struct.unpack(order + "4I", head)
            frame = file.read(size)
            if frame[12:14] != b"\x08\x00" or frame[23] != 17: # IPv4, UDP
                continue
            udp = 14 + 4 * (frame[14] & 15)
            length = struct.unpack_from(">H", frame, udp + 4)[0] # Ethernet pads short frames
            yield seconds + microseconds / 1e6, frame[udp + 8:udp + length]


def rows(path):
    """(time, source, destination, message, field, value); messages that are not known are left out."""
    for time, payload in datagrams(path):
        try:
            messages = jauscat.decode_datagram(payload)
        except (jauscat.DecodeError, jauscat.UnknownMessageError):
            continue
        for message in messages:
            for field, value in message.fields.items():
                yield time, message.source, message.destination, message.name, field, value
# [rows end]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Writes the fields of all messages of a capture as CSV.",
                                     epilog="Example: capture_to_rows.py traffic.pcap >traffic.csv")
    parser.add_argument("capture", help="a pcap file of Ethernet frames")
    writer = csv.writer(sys.stdout)
    writer.writerow(["time", "source", "destination", "message", "field", "value"])
    try:
        writer.writerows(rows(parser.parse_args().capture))
    except (OSError, ValueError) as error:
        sys.exit(f"capture_to_rows.py: {error}")
