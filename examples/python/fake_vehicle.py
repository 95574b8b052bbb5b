# A vehicle without hardware: a driver, and a sensor of the velocity that follows the effort.
import argparse
import sys

import jauscat

parser = argparse.ArgumentParser(description="A Primitive Driver (33) and a Velocity State Sensor (42), until Ctrl-C.",
                                 epilog="Example: fake_vehicle.py --config JausConfig.xml --this robot")
parser.add_argument("--config", default="JausConfig.xml")
parser.add_argument("--this", default="robot", help="the system of the configuration that it is")
options = parser.parse_args()

# [vehicle]
efforts = jauscat.message("report_wrench_effort").fields
velocities = [field for field in jauscat.message("report_velocity_state").fields if field.unit]
effort = {}


def command(message):
    effort.update(message.fields)


def report_velocity(query):
    at_rest = {field.name: 0 for field in velocities}
    return {**at_rest, "velocity_x": effort.get("propulsive_linear_effort_x", 0) / 10} # 10 m/s at full effort


try:
    node = jauscat.Node(options.config, this_system=options.this)
    driver = node.component(id=33, name="Primitive Driver")
    driver.on("set_wrench_effort", command)
    driver.on("query_wrench_effort", lambda query: {**{field.name: 0 for field in efforts}, **effort})
    driver.when_stopped(effort.clear) # not Ready, emergency, controller lost
    driver.ready()
    sensor = node.component(id=42, name="Velocity State Sensor")
    sensor.on("query_velocity_state", report_velocity)
    sensor.ready()
    node.start()
    print(f"{driver.address} and {sensor.address} run (Ctrl-C ends)", flush=True)
    node.run()
except KeyboardInterrupt:
    pass
except jauscat.Error as error:
    sys.exit(f"fake_vehicle.py: {error}")
# [vehicle end]
