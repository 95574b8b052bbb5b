"""Every capture and every golden message, as tshark shows it by the dissector, is what jausdump says.

  dissector_test.py SOURCE_FOLDER JAUSDUMP
"""
import os
import shutil
import sys
import tempfile

import captures
import compare

SKIPPED = 77


def main():
    source, jausdump = sys.argv[1:]
    if shutil.which("tshark") is None:
        print("skipped: tshark is missing (apt-get install tshark)")
        return 1 if os.environ.get("CI") == "true" and os.geteuid() == 0 else SKIPPED
    data = os.path.join(source, "tests", "data")
    dissector = os.path.join(source, "tools", "wireshark", "jauscat.lua")
    ra, sae = os.path.join(data, "ra_vectors.jsonl"), os.path.join(data, "sae_vectors.jsonl")
    made = {
        "ra_vectors": captures.udp(captures.ra_datagrams(ra)),
        "sae_vectors": captures.udp(captures.sae_datagrams(sae)),
        "sae_stream": captures.tcp(datagram[1:] for datagram in captures.sae_datagrams(sae)),
        "ra_data_sets": captures.udp(captures.ra_data_sets(ra)),
        "sae_fragments": captures.udp(captures.sae_fragments(sae)),
    }
    all_decoded = {"ra_vectors": 1255, "sae_vectors": 1444, "sae_stream": 1444}
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        cases = [(name, os.path.join(folder, name + ".pcap"), (), ()) for name in made]
        for name, path, _, _ in cases:
            captures.write(path, made[name])
        for name in ("jaus_ra", "sae_management"):
            cases.append((name, os.path.join(data, name + ".pcap"), (), ()))
        for name, path, dump_arguments, tshark_arguments in cases:
            try:
                count, decoded = compare.require_same(dissector, jausdump, path, dump_arguments, tshark_arguments)
                if decoded != all_decoded.get(name, decoded) or decoded == 0:
                    raise compare.Difference(f"{name}: jausdump decodes {decoded} of {count} messages")
                print(f"{name}: {count} messages, {decoded} decoded")
            except compare.Difference as difference:
                print(difference, file=sys.stderr)
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
