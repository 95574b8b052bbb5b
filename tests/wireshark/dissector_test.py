"""Every capture and every golden message, as tshark shows it by the dissector, is what jausdump says.

  dissector_test.py SOURCE_FOLDER JAUSDUMP
"""
import os
import random
import shutil
import struct
import sys
import tempfile

import captures
import compare

SKIPPED = 77
PLAIN = 200  # a port that is no other protocol's


class Cases:
    """What is compared; the captures that are made lie in `folder`."""

    def __init__(self, source, jausdump, folder):
        self.jausdump, self.folder, self.source = jausdump, folder, source
        self.data = os.path.join(source, "tests", "data")
        self.dissector = os.path.join(source, "tools", "wireshark", "jauscat.lua")
        self.ra, self.sae = (os.path.join(self.data, name) for name in ("ra_vectors.jsonl", "sae_vectors.jsonl"))

    def made(self, name, packets, link_type=101):
        path = os.path.join(self.folder, name + ".pcap")
        captures.write(path, packets, link_type)
        return path

    def same(self, capture, decoded=None, dump=(), tshark=()):
        """The numbers of messages and of decoded ones; the latter must be `decoded`."""
        counts = compare.require_same(self.dissector, self.jausdump, capture, dump, tshark)
        if counts[1] != decoded:
            raise compare.Difference(f"{os.path.basename(capture)}: jausdump decodes {counts[1]} of {counts[0]} messages")

    def recorded_messages(self):
        self.same(os.path.join(self.data, "jaus_ra.pcap"), 1746)
        self.same(os.path.join(self.data, "sae_management.pcap"), 21)

    def golden_messages_of_ra(self):
        self.same(self.made("ra_vectors", captures.udp(captures.ra_datagrams(self.ra))), 1255)

    def golden_messages_of_sae(self):
        self.same(self.made("sae_vectors", captures.udp(captures.sae_datagrams(self.sae))), 1444)

    def golden_messages_in_a_stream(self):
        messages = (datagram[1:] for datagram in captures.sae_datagrams(self.sae))
        self.same(self.made("sae_stream", captures.tcp(messages)), 1444)

    def messages_of_several_packets(self):
        self.same(self.made("ra_data_sets", captures.udp(captures.ra_data_sets(self.ra))), 85)
        self.same(self.made("sae_fragments", captures.udp(captures.sae_fragments(self.sae))), 186)

    def any_port_by_decode_as(self):
        ra, sae = list(captures.ra_datagrams(self.ra))[:9], list(captures.sae_datagrams(self.sae))[:9]
        capture = self.made("port", captures.udp(ra + sae, PLAIN))
        self.same(capture, 18, tshark=["-d", f"udp.port=={PLAIN},jaus"])
        capture = self.made("tcp_port", captures.tcp([one[1:] for one in sae], port=PLAIN))
        self.same(capture, 9, tshark=["-d", f"tcp.port=={PLAIN},jaus"])

    def recorded_ethercat(self):
        for name, table, decoded in (("jauscat_seed", "seed", 9), ("jauscat_self_contained", "self-contained", 8),
                                     ("soem_soes", "seed", 0), ("kickcat", "seed", 0)):
            capture = os.path.join(self.data, f"ethercat_{name}.pcap")
            for choice in (table, "RA"):
                self.same(capture, decoded, ["--ethercat", table], ["-o", f"jaus.ethercat_table:{choice}"])

    def golden_messages_in_ethercat(self):
        codes = captures.ranks(self.dissector, "ra_ranks")
        for table, base, fixed_length in (("seed", 0x2000, False), ("seed", 0x6900, False),
                                          ("self-contained", 6900, True)):
            objects = list(captures.ra_objects(self.ra, codes, base, table, fixed_length))
            capture = self.made(f"ethercat_{table}_{base}", captures.ethercat(objects), 1)
            dump = ["--ethercat", table, "--subsystem", "2", "--index-base", hex(base) if base > 6900 else str(base)]
            tshark = ["-o", f"jaus.ethercat_table:{table}", "-o", f"jaus.ethercat_index_base:{base}",
                      "-o", "jaus.ethercat_subsystem:2"]
            if fixed_length:
                dump, tshark = dump + ["--fixed-length"], tshark + ["-o", "jaus.ethercat_fixed_length:TRUE"]
            self.same(capture, len(objects), dump, tshark)

    def golden_messages_of_sae_in_ethercat(self):
        segments = captures.sae_segments(self.source)
        known = {code for codes in segments for code in codes}
        messages = [one[1:] for one in captures.sae_datagrams(self.sae)
                    if struct.unpack_from("<H", one, 13)[0] in known and len(one) < 1500]
        wanted = compare.messages_of_jausdump(
            self.jausdump, self.made("sae", captures.udp(b"\x02" + one for one in messages)))
        for base in 0x2000, 0x6900:
            frames, packets = [], []
            counter = captures.ethercat_counter()
            for one in messages:
                frames += captures.ethercat(captures.sae_objects([one], segments, base), counter=counter)
                packets.append(len(frames))
            capture = self.made(f"ethercat_sae_{base}", frames, 1)
            compare.require_shown(wanted, self.dissector, capture,
                                  ["-o", "jaus.ethercat_table:SAE", "-o", f"jaus.ethercat_index_base:{base}"], packets)

    def filters_by_value(self):
        """Efforts of 50, 5 and -50 %, and the same in messages of SAE."""
        efforts = (50, 5, -50)
        signed = [struct.pack("<Hh", 1, round(percent / 100 * 32767)) for percent in efforts]
        unsigned = [struct.pack("<HHH", 0x0405, 1, round((percent + 100) / 200 * 65535)) for percent in efforts]
        capture = self.made("filter", captures.udp(
            [captures.ra_message(0x0405, body) for body in signed] +
            [b"\x02" + captures.transport(payload, 1) for payload in unsigned]))
        effort = "jaus.set_wrench_effort.propulsive_linear_effort_x"
        compare.require_frames(self.dissector, capture, f"{effort} > 10", [1, 4])
        compare.require_frames(self.dissector, capture, f"{effort} < 0", [3, 6])
        compare.require_frames(self.dissector, capture, 'jaus.source == "1.1.32"', [4, 5, 6])
        compare.require_frames(self.dissector, capture, "jaus.command_code == 0x405", [1, 2, 3])

    def query_and_report_are_linked(self):
        """A query to one component, a query to all, and their reports; a report that nobody asked for."""
        a, b, everyone = (bytes(parts) for parts in ((1, 32, 1, 1), (1, 33, 1, 2), (1, 33, 255, 255)))
        query, report = bytes([1, 0]), bytes([1, 0, 0, 64])
        capture = self.made("links", captures.udp([
            captures.ra_message(0x4405, report, a, b),
            captures.ra_message(0x2405, query, b, a), captures.ra_message(0x4405, report, a, b),
            captures.ra_message(0x2405, query, everyone, a), captures.ra_message(0x4405, report, a, b)]))
        compare.require_frames(self.dissector, capture, "jaus.report_in == 3", [2])
        compare.require_frames(self.dissector, capture, "jaus.query_in == 2", [3])
        compare.require_frames(self.dissector, capture, "jaus.report_in == 5", [4])
        compare.require_frames(self.dissector, capture, "jaus.query_in == 4 && jaus.response_time == 0.001", [5])
        compare.require_frames(self.dissector, capture, "jaus.query_in || jaus.report_in", [2, 3, 4, 5])

    def damaged_messages_have_expert_information(self):
        """Where jausdump decodes one, a bit without a meaning may be shown that jausdump leaves out."""
        capture = self.made("damaged", captures.udp(captures.damaged_datagrams(self.ra, self.sae, random.Random(1))))
        wanted = compare.messages_of_jausdump(self.jausdump, capture)
        shown = compare.messages_of_tshark(self.dissector, capture)
        if len(wanted) != len(shown):
            raise compare.Difference(f"tshark shows {len(shown)} messages, jausdump {len(wanted)}")
        outside = 0
        for record, (number, proto) in zip(wanted, shown):
            if "error" in record and not compare.has_expert_info(proto):
                raise compare.Difference(f"frame {number}: no expert information says: {record['error']['text']}")
            if "error" in record or compare.holds_a_message(proto):  # of what jausdump does not decode
                continue
            if ("outside_values" in record) != compare.has_expert_info(proto, "jaus.outside_values"):
                raise compare.Difference(f"frame {number}: outside values: jausdump says {record.get('outside_values')}")
            outside += "outside_values" in record
        if outside < 10:
            raise compare.Difference(f"only {outside} messages have outside values")

    def faults_have_expert_information(self):
        message = captures.ra_message

        def payload(text):
            return b"\x02" + captures.transport(bytes.fromhex(text), 1)
        capture = self.made("faults", captures.udp([
            message(0x0405, bytes([1, 0, 0, 64])),            # good
            message(0x0405, bytes([3, 0, 0, 64])),            # truncated
            message(0x0405, bytes([1, 0, 0, 64, 9])),         # trailing
            message(0x0405, bytes([1, 0, 0, 128])),           # out of range
            message(0xD123, bytes([1])),                      # unknown command code
            message(0x0405, bytes([1, 128, 0, 64])),          # unknown presence bit
            payload("0d0023"), payload("0d00"), payload("0d002300"), payload("ffff00"), payload("0d")]))
        for display_filter, frames in (("jaus.truncated", [2, 8, 11]), ("jaus.trailing", [3, 9]), ("jaus.out_of_range", [4]),
                                       ("jaus.unknown", [5, 6, 10])):
            compare.require_frames(self.dissector, capture, display_filter, frames)


def main():
    source, jausdump = sys.argv[1:]
    if shutil.which("tshark") is None:
        print("skipped: tshark is missing (apt-get install tshark)")
        return 1 if os.environ.get("CI") == "true" and os.geteuid() == 0 else SKIPPED
    failed = False
    with tempfile.TemporaryDirectory() as folder:
        cases = Cases(source, jausdump, folder)
        for name in (name for name in vars(Cases) if name not in ("made", "same") and not name.startswith("_")):
            try:
                getattr(cases, name)()
                print(name.replace("_", " ") + ": as wanted")
            except compare.Difference as difference:
                print(f"{name.replace('_', ' ')}: {difference}", file=sys.stderr)
                failed = True
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
