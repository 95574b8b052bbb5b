# Takes control of a component, commands it, and shows what it reports.
import argparse
import sys

import jauscat

parser = argparse.ArgumentParser(description="Sends Set Wrench Effort to a Primitive Driver, and asks for the efforts in force.",
                                 epilog="Example: send_a_command.py --config JausConfig.xml 2.2.33.1 50")
parser.add_argument("--config", default="JausConfig.xml", help="the configuration; its <thissystem> is this program")
parser.add_argument("driver", help="JAUS ID of the driver: 2.2.33.1")
parser.add_argument("effort", type=float, help="forward effort, -100 to 100 %%")
options = parser.parse_args()

try:
    # [send]
    node = jauscat.Node(options.config)
    operator = node.component(id=32, name="operator")
    with node, operator.control(options.driver, authority=100) as control:
        control.send("set_wrench_effort", {"propulsive_linear_effort_x": options.effort})
        report = operator.ask(options.driver, "query_wrench_effort", {"presence_vector": 1})
    print(f"in force: {report['propulsive_linear_effort_x']:.3f} %")
    # [send end]
except (ValueError, jauscat.Error) as error: # ValueError: no JAUS ID
    sys.exit(f"send_a_command.py: {error}")
