"""Makes captures of the golden messages of both generations, over UDP and TCP."""
import json
import struct

RA_DESTINATION = bytes([1, 33, 1, 2])
SAE_SOURCE, SAE_DESTINATION = bytes([32, 1, 1, 0]), bytes([33, 1, 2, 0])
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


def ra_datagrams(path):
    """Each message once, by one of the three framings, in one packet, without acknowledgement. Each has a source of its
    own, so that jausdump knows of no payload interface by which it would decode payload data elements."""
    for number, message in enumerate(vectors(path)):
        properties = message[0] & 0xCF
        head = bytes([properties, 2]) + message[2:4] + RA_DESTINATION + ra_source(number)
        head += struct.pack("<HH", len(message) - 16, number % 65536)
        yield framed(head + message[16:], number % 3)


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


def write(path, packets):
    """Packets of raw IP, a millisecond apart."""
    with open(path, "wb") as file:
        file.write(struct.pack("<IHHiIII", 0xA1B2C3D4, 2, 4, 0, 0, 262144, 101))
        for number, packet in enumerate(packets):
            file.write(struct.pack("<IIII", 1000000000 + number // 1000, number % 1000 * 1000, len(packet), len(packet)))
            file.write(packet)
