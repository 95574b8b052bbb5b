#!/usr/bin/env python3
"""A component of a foreign robot that never acknowledges, and is its own node manager.

silent_peer.py PORT OPERATOR_PORT obeys|ignores|mute [NODE]: the component 2.NODE.33.1, or 2.2.33.1. Obeys Set Wrench
Effort or does not; mute, it never reports. It reports by service connection, too.
"""
import socket
import struct
import sys
import time

REQUEST_CONTROL, CONFIRM_CONTROL = 0x000D, 0x000F
SET_EFFORT, QUERY_EFFORT, REPORT_EFFORT, HEARTBEAT = 0x0405, 0x2405, 0x4405, 0x4202
CREATE_CONNECTION, CONFIRM_CONNECTION, TERMINATE_CONNECTION = 0x0008, 0x0009, 0x000C
NODE = int(sys.argv[4]) if len(sys.argv) > 4 else 2
SELF = bytes([1, 33, NODE, 2])  # instance, component, node, subsystem
OPERATORS_MANAGER = bytes([1, 1, 1, 1])

port, operator_port, manner = int(sys.argv[1]), int(sys.argv[2]), sys.argv[3]
peer = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
peer.bind(("127.0.0.1", port))


def send(code, destination, body=b"", connection=False, number=0):
    properties = 0x0246 if connection else 0x0206
    head = struct.pack("<HH", properties, code) + destination + SELF + struct.pack("<HH", len(body), number)
    try:
        peer.sendto(head + body, ("127.0.0.1", operator_port))
    except ConnectionRefusedError:
        pass


efforts = struct.pack("<HH", 1, 0)  # presence vector, propulsive linear effort x
next_heartbeat = 0.0
connected, number = None, 0
print("silent peer: ready", flush=True)
while True:
    if time.monotonic() >= next_heartbeat:
        send(HEARTBEAT, OPERATORS_MANAGER)
        next_heartbeat = time.monotonic() + 0.3
    if connected:
        send(REPORT_EFFORT, connected, efforts, True, number)
        number += 1
    peer.settimeout(0.05)
    try:
        message = peer.recv(4096)
    except (socket.timeout, ConnectionRefusedError):
        continue
    code, source, body = struct.unpack_from("<H", message, 2)[0], message[8:12], message[16:]
    if code == REQUEST_CONTROL:
        send(CONFIRM_CONTROL, source, b"\0")
    elif code == SET_EFFORT and manner != "ignores":
        efforts = body
    elif code == CREATE_CONNECTION and manner != "mute":
        connected, number = source, 0
        send(CONFIRM_CONNECTION, source, body[:2] + b"\1" + body[2:4] + b"\0")
    elif code == TERMINATE_CONNECTION:
        connected = None
    elif code == QUERY_EFFORT and manner != "mute":
        send(REPORT_EFFORT, source, efforts)
