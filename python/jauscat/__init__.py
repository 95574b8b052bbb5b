"""JAUS messages by name, their translation for EtherCAT, and JAUS nodes for test benches."""
from ._jauscat import *
from ._jauscat import __version__
