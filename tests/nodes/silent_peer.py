#!/usr/bin/env python3
"""The component 2.2.33.1 of a foreign robot that never acknowledges, and is its own node manager.

silent_peer.py PORT OPERATOR_PORT obeys|ignores|mute: obeys Set Wrench Effort or does not; mute, it never reports.
"""
import socket
import struct
import sys
import time

REQUEST_CONTROL, CONFIRM_CONTROL = 0x000D, 0x000F
SET_EFFORT, QUERY_EFFORT, REPORT_EFFORT, HEARTBEAT = 0x0405, 0x2405, 0x4405, 0x4202
SELF = bytes([1, 33, 2, 2])  # instance, component, node, subsystem
OPERATORS_MANAGER = bytes([1, 1, 1, 1])

port, operator_port, manner = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
peer.bind(("127.0.0.1", port))


def send(code, destination, body=b""):
    head = struct.pack("<HH", 0x0206, code) + destination + SELF + struct.pack("<HH", len(body), 0)
    try:
        peer.sendto(head + body, ("127.0.0.1", operator_port))
    except ConnectionRefusedError:
        pass


efforts = struct.pack("<HH", 1, 0)  # presence vector, propulsive linear effort x
next_heartbeat = 0.0
print("silent peer: ready", flush=True)
while True:
    if time.monotonic() >= next_heartbeat:
        send(HEARTBEAT, OPERATORS_MANAGER)
        next_heartbeat = time.monotonic() + 0.3
    peer.settimeout(0.1)
    try:
        message = peer.recv(4096)
    except (socket.timeout, ConnectionRefusedError):
        continue
    code, source, body = struct.unpack_from("<H", message, 2)[0], message[8:12], message[16:]
    if code == REQUEST_CONTROL:
        send(CONFIRM_CONTROL, source, b"\0")
    elif code == SET_EFFORT and manner != "ignores":
        efforts = body
    elif code == QUERY_EFFORT and manner != "mute":
        send(REPORT_EFFORT, source, efforts)
