"""Configurations of an operator and a robot on the loopback interface, on ports that are free."""
import socket


def configuration(robot="2.1.0.0"):
    sockets = [socket.socket(socket.AF_INET, socket.SOCK_DGRAM) for _ in range(2)]
    for one in sockets:
        one.bind(("127.0.0.1", 0))
    ports = [one.getsockname()[1] for one in sockets]
    for one in sockets:
        one.close()
    return f"""<jausconfig thissystem="operator">
  <system name="operator" jausip="1.1.0.0" ip="127.0.0.1" port="{ports[0]}"/>
  <system name="robot" jausip="{robot}" ip="127.0.0.1" port="{ports[1]}"/>
</jausconfig>
"""
