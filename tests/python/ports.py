"""Configurations of an operator and a robot on the loopback interface, on ports that are free."""
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "scripts"))
from free_ports import free_ports


def configuration(robot="2.1.0.0"):
    ports = free_ports(2)
    return f"""<jausconfig thissystem="operator">
  <system name="operator" jausip="1.1.0.0" ip="127.0.0.1" port="{ports[0]}"/>
  <system name="robot" jausip="{robot}" ip="127.0.0.1" port="{ports[1]}"/>
</jausconfig>
"""
