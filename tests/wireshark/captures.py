"""Makes captures of the golden messages of both generations, over UDP and TCP."""
import itertools
import json
import os
import re
import struct

RA_DESTINATION = bytes([1, 33, 1, 2])
SAE_SOURCE, SAE_DESTINATION = bytes([32, 1, 1, 0]), bytes([33, 2, 2, 0])
PORT = 3794


def vectors(path):
    with open(path) as lines:
        return [bytes.fromhex(json.loads(line)["hex"]) for line in lines]


def framed(message, how):
    if how == 0:
        return message
    if how == 1:
        return b"JAUS01.0" + message
    return bytes([1, 0, 0]) + struct.pack(">H", len(message)) + message


def ra_source(number):
    return bytes([1, 32, 1 + number % 200, 1 + number // 200])


def ra_message(code, body, destination=RA_DESTINATION, source=ra_source(0)):
    return struct.pack("<HH", 0x0206, code) + destination + source + struct.pack("<HH", len(body), 0) + body


def ra_datagrams(path):
    """Each message once, by one of the three framings, in one packet, without acknowledgement. Each has a source of its
    own, so that jausdump knows of no payload interface by which it would decode payload data elements."""
    for number, message in enumerate(vectors(path)):
        properties = message[0] & 0xCF
        head = bytes([properties, 2]) + message[2:4] + RA_DESTINATION + ra_source(number)
        head += struct.pack("<HH", len(message) - 16, number % 65536)
        yield framed(head + message[16:], number % 3)


def damaged(body, begin, random):
    """A few bytes from `begin` on are changed, cut off or added."""
    made = bytearray(body)
    for _ in range(random.choice([1, 1, 2, 3])):
        kind = random.choice(["change", "change", "cut", "add"])
        if kind == "add":
            made += random.randbytes(random.randrange(1, 9))
        elif len(made) > begin and kind == "change":
            made[random.randrange(begin, len(made))] = random.choice([0, 255, 1, 128, random.randrange(256)])
        elif len(made) > begin:
            del made[random.randrange(begin, len(made)):]
    return bytes(made)


def damaged_datagrams(ra, sae, random):
    for number, message in enumerate(vectors(ra)):
        code = struct.unpack_from("<H", message, 2)[0]
        yield b"JAUS01.0" + ra_message(code, damaged(message[16:], 0, random), source=ra_source(number))
    for number, payload in enumerate(vectors(sae)):
        yield b"\x02" + transport(damaged(payload, 2, random), number)


def transport(payload, number, fragment=0):
    properties = 1 | fragment << 6
    head = bytes([0]) + struct.pack("<H", len(payload) + 14) + bytes([properties]) + SAE_DESTINATION + SAE_SOURCE
    return head + payload + struct.pack("<H", number % 65536)


def sae_datagrams(path):
    for number, payload in enumerate(vectors(path)):
        yield b"\x02" + transport(payload, number)


def ra_data_sets(path):
    """Messages in packets of 16 bytes of body, the first two packets exchanged, each of another source."""
    flags = {"first": 1, "middle": 2, "last": 8}
    for count, message in enumerate(vectors(path)):
        parts = [message[at:at + 16] for at in range(16, len(message), 16)]
        if len(parts) < 3:
            continue
        packets = []
        for number, part in enumerate(parts):
            flag = flags["first" if number == 0 else "last" if number + 1 == len(parts) else "middle"]
            head = bytes([6, 2]) + message[2:4] + RA_DESTINATION + ra_source(count)
            packets.append(head + struct.pack("<HH", len(part) | flag << 12, number) + part)
        packets[0], packets[1] = packets[1], packets[0]
        yield from packets


def sae_fragments(path):
    """The same for SAE, in fragments of 16 bytes of payload, around the end of the sequence numbers too."""
    number = 65000
    for payload in vectors(path):
        parts = [payload[at:at + 16] for at in range(0, len(payload), 16)]
        if len(parts) < 3:
            continue
        packets = []
        for at, part in enumerate(parts):
            fragment = 1 if at == 0 else 3 if at + 1 == len(parts) else 2
            packets.append(b"\x02" + transport(part, number, fragment))
            number += 1
        packets[0], packets[1] = packets[1], packets[0]
        yield from packets


def ip(protocol, payload):
    return struct.pack(">BBHHHBBH4s4s", 0x45, 0, 20 + len(payload), 0, 0, 64, protocol, 0,
                       bytes([10, 0, 0, 1]), bytes([10, 0, 0, 2])) + payload


def udp(datagrams, port=PORT):
    for datagram in datagrams:
        yield ip(17, struct.pack(">HHHH", port, port, 8 + len(datagram), 0) + datagram)


def tcp(messages, segment=1000, port=PORT):
    """One stream, behind the version byte, cut where no message ends."""
    def packet(at, flags, data=b""):
        return ip(6, struct.pack(">HHIIBBHHH", 40000, port, at, 1, 5 << 4, flags, 65535, 0, 0) + data)
    stream = b"\x02" + b"".join(messages)
    yield packet(0, 2)
    for at in range(0, len(stream), segment):
        yield packet(1 + at, 0x18, stream[at:at + segment])


def ranks(dissector, name):
    """Codes by subindex, from 1, as in the dissector; what uses them is compared with what does not."""
    with open(dissector) as script:
        line = next(line for line in script if line.startswith(f"local {name} = "))
    return [int(code, 16) for code in re.findall("0x[0-9A-F]{4}", line)]


def sae_segments(source):
    """Codes of each segment, by subindex, from 1."""
    with open(os.path.join(source, "schemas/jauscat/schema/translation/sae_ranks.hpp")) as header:
        lists = re.findall(r"sae_\w+_ids\{([^}]*)\}", header.read())
    return [[int(code, 16) for code in re.findall("0x[0-9A-F]{4}", one)] for one in lists]


def ra_objects(path, codes, base, table, fixed_length=False):
    """Index, subindex and data of messages to component 33."""
    for datagram in ra_datagrams(path):
        at = datagram.find(RA_DESTINATION) - 4
        head, body = datagram[at:at + 16], datagram[at + 16:]
        code = struct.unpack_from("<H", head, 2)[0]
        if code not in codes or len(body) > 1500:
            continue
        data = head[0:2]
        if table == "self-contained":
            data += head[4:5] + head[7:8] + head[8:12] + head[12:14]
        else:
            data += head[8:12]
        data += head[14:16] + body
        yield base + 33, codes.index(code) + 1, struct.pack("<H", len(data)) + data + bytes(5) if fixed_length else data


def sae_objects(messages, segments, base):
    """The same of whole messages of SAE JAUS."""
    for message in messages:
        code = struct.unpack_from("<H", message, 12)[0]
        segment, codes = next((n, codes) for n, codes in enumerate(segments) if code in codes)
        data = message[3:4] + message[6:8] + message[8:12] + message[14:]
        yield base + 256 * segment + 33, codes.index(code) + 1, data


def ethercat_counter():
    """Counters of mailbox messages, 1 to 7."""
    return itertools.cycle(range(1, 8))


def ethercat(objects, mailbox=128, counter=None):
    """Downloads to the slave with station address 2, each frame on its way out and back."""
    counters = counter or ethercat_counter()

    def frames(sdo):
        counter = next(counters)
        message = struct.pack("<HHBBH", len(sdo) + 2, 0, 0, 3 | counter << 4, 2 << 12) + sdo
        message += bytes(mailbox - len(message))
        for working_counter in (0, 1):
            datagram = struct.pack("<BBHHHH", 5, counter, 2, 0x1000, len(message), 0) + message
            datagram += struct.pack("<H", working_counter)
            yield bytes([255] * 6 + [2, 0, 0, 0, 0, 1]) + b"\x88\xa4" + struct.pack("<H", len(datagram) | 1 << 12) + datagram

    for index, subindex, data in objects:
        room = mailbox - 6 - 2 - 8
        yield from frames(struct.pack("<BHBI", 0x21, index, subindex, len(data)) + data[:room])
        toggle, left = 0, data[room:]
        while left:
            part, left = left[:room + 7], left[room + 7:]
            unused = max(7 - len(part), 0)
            yield from frames(bytes([toggle << 4 | unused << 1 | (not left)]) + part + bytes(unused))
            toggle = 1 - toggle


def write(path, packets, link_type=101):
    """Packets of raw IP, or of Ethernet with `link_type` 1, a millisecond apart."""
    with open(path, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 262144, link_type))
        for number, packet in enumerate(packets):
            file.write(struct.pack("<IIII", 1000000000 + number // 1000, number % 1000 * 1000, len(packet), len(packet)))
            file.write(packet)
