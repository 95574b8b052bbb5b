"""Ports for programs that must know each other's before they have them."""
import errno
import random
import socket

marks = []  # sockets of the other kind at the ports that were given, until the program ends


def free_ports(count, kind=socket.SOCK_DGRAM):
    """Ports that nobody has at 127.0.0.1, and that no other call has given, here or in a program that runs beside.

    They lie below those that a system gives to sockets that want any (on Linux 32768 and up), so that no other socket gets one in the
    meantime.
    """
    other = socket.SOCK_STREAM if kind == socket.SOCK_DGRAM else socket.SOCK_DGRAM
    ports = []
    while len(ports) < count:
        port = random.randrange(10_000, 32_768)
        mark = socket.socket(socket.AF_INET, other)
        try:
            mark.bind(("127.0.0.1", port))
            with socket.socket(socket.AF_INET, kind) as one:
                one.bind(("127.0.0.1", port))
        except OSError as error:
            mark.close()
            if error.errno != errno.EADDRINUSE:
                raise
            continue
        marks.append(mark)
        ports.append(port)
    return ports
