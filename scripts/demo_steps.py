"""Runs the programs of the demonstration and judges each step by the events that they log. Started by scripts/demo."""
import argparse
import json
import math
import os
import pathlib
import random
import re
import signal
import struct
import subprocess
import sys
import tempfile
import threading
import time

from free_ports import free_ports

root = pathlib.Path(__file__).resolve().parent.parent
wait_limit = 15  # seconds
axes = [f"{kind}_effort_{axis}" for kind in ("propulsive_linear", "propulsive_rotational", "resistive_linear", "resistive_rotational")
        for axis in "xyz"]
set_wrench_effort = 0x0405
set_joint_positions, report_joint_positions = 0x0602, 0x4602
joints = ["waist", "shoulder", "elbow", "forearm", "wrist", "hand"]
names = {"a": "ocu a", "c": "ocu c", "robot_controller": "controller", "robot_arm": "arm", "six": "controller",
         "drives": "six drives"}

coloured = sys.stdout.isatty() and not os.environ.get("NO_COLOR") and os.environ.get("TERM") != "dumb"


def paint(text, colour):
    codes = {"bold": 1, "red": 31, "green": 32, "yellow": 33, "blue": 34, "magenta": 35, "cyan": 36, "faint": 2}
    return f"\033[{codes[colour]}m{text}\033[0m" if coloured and text else text


class Failed(Exception):
    """The demonstration cannot continue."""


class Program:
    """A process that logs JSON lines."""

    def __init__(self, log, name, command, script=""):
        self.name = name
        self.log = log
        # In a session of its own: Ctrl-C goes to the demonstration, which ends the programs in order.
        self.process = subprocess.Popen(command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                                        start_new_session=True)
        self.process.stdin.write(script)
        self.process.stdin.close()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            try:
                event = json.loads(line)
            except ValueError:  # such as a sanitizer's report
                event = {"event": "text", "time": time.monotonic(), "text": line.rstrip("\n")}
            self.log.add({**event, "by": self.name})

    def wait(self):
        try:
            code = self.process.wait(wait_limit)
        except subprocess.TimeoutExpired:
            raise Failed(f"{names[self.name]} did not end within {wait_limit} seconds") from None
        self.reader.join(wait_limit)
        return code

    def end(self, how=signal.SIGINT):
        if self.process.poll() is None:
            self.process.send_signal(how)
        return self.wait()


class Log:
    """The events of all programs."""

    def __init__(self):
        self.events = []
        self.changed = threading.Condition()
        self.begin = time.monotonic()

    def add(self, event):
        with self.changed:
            self.events.append(event)
            self.changed.notify_all()

    def find(self, by, name, since=0, **members):
        with self.changed:
            return [event for event in self.events[since:] if event["by"] == by and event["event"] == name
                    and all(event.get(member) == value for member, value in members.items())]

    def wait_for(self, condition):
        """What `condition()` returns, once that is not empty."""
        until = time.monotonic() + wait_limit
        while not (found := condition()) and time.monotonic() < until:
            with self.changed:
                self.changed.wait(0.02)
        return found


def hexadecimal(data):
    return bytes(data).hex(" ")


def from_hexadecimal(text):
    return bytes.fromhex(text) if re.fullmatch(r"\s*([0-9a-f]{2}( |$))*", text) else b""


def efforts_of(body):
    """The raw values in the body of Set or Report Wrench Effort: a presence vector, six of 16 bits, six of 8."""
    (vector,), at, values = struct.unpack_from("<H", body), 2, {}
    for bit, axis in enumerate(axes):
        if vector >> bit & 1:
            form = "<h" if bit < 6 else "<B"
            (values[axis],) = struct.unpack_from(form, body, at)
            at += struct.calcsize(form)
    return values

# Of a controller: longer than a busy machine keeps a program waiting. In cycles, slaves are lost after two periods.
patience = ["--frame-timeout", "200", "--stop-within", "2000"]


def positions_of(body):
    """Radians, in the body of Set or Report Joint Positions: a number, and 32 bits for each."""
    return [raw * 16 * math.pi / (2**32 - 1) - 8 * math.pi for (raw,) in struct.iter_unpack("<I", body[1:])]


def percent(axis, raw):
    return raw / 32767 * 100 if axis.startswith("propulsive") else raw / 255 * 100


class Demonstration:
    def __init__(self, options):
        self.options = options
        self.folder = tempfile.TemporaryDirectory()
        self.log = Log()
        self.programs = []
        self.efforts = dict.fromkeys(axes, 0)  # that the arm should hold
        self.printed = 0
        self.step_begin = 0
        self.problems = []
        self.steps = self.failures = 0
        *jaus, arm_port, self.drives_port, self.ethercat_port = free_ports(6)  # several demonstrations run beside each other
        config = (root / "examples/JausConfig.xml").read_text(encoding="utf-8")
        for system, port in enumerate(jaus):
            config = config.replace(f"<port>{39777 + system}<", f"<port>{port}<")
        slaves = "".join(f'<slave name="{joint}" position="{i}" vendor="0x4A43" product="0x402">'
                         '<sdo index="0x6060" type="SINT" value="8"/></slave>' for i, joint in enumerate(joints))
        config = config.replace("</jausconfig>", f'''
  <system name="d" jausip="4.2.0.0" ip="127.0.0.1" port="{arm_port}">
    <ethercat interface="udp:127.0.0.1:{self.drives_port}">{slaves}</ethercat>
    <component id="54" slaves="{' '.join(joints)}"/>
  </system>
</jausconfig>''')
        self.config = pathlib.Path(self.folder.name) / "JausConfig.xml"
        self.config.write_text(config, encoding="utf-8")

    # Processes.

    def start(self, name, program, *arguments, script=""):
        return self.start_command(name, program, "--config", str(self.config), "--log-format", "json", *arguments, script=script)

    def start_command(self, name, program, *arguments, script=""):
        command = [str(pathlib.Path(self.options.bin) / program), *arguments]
        try:
            self.programs.append(Program(self.log, name, command, script))
        except OSError as error:
            raise Failed(f"{command[0]}: {error.strerror}") from None
        return self.programs[-1]

    def start_robot(self, name):
        program = self.start(name, name, "--this", "b", "--table", self.options.table, "--ethercat-port", str(self.ethercat_port),
                             *(patience if name == "robot_controller" else []))
        self.require(name, "ready")
        return program

    def unit(self, code, name, *arguments):
        """Runs an operator control unit, which should end with this exit code."""
        self.expect(self.start(name, "ocu", "--this", name, *arguments).wait(), code, f"exit code of {names[name]}")

    def hold(self, name, *arguments):
        """Starts an operator control unit that keeps control."""
        unit = self.start(name, "ocu", "--this", name, "--hold", "120", *arguments)
        self.require(name, "holding")
        return unit

    def end(self):
        """Ends all programs; the last one first, because the controller brings the arm to rest."""
        for program in reversed(self.programs):
            if program.process.poll() is None:
                program.process.send_signal(signal.SIGINT)
                try:
                    program.process.wait(5)
                except subprocess.TimeoutExpired:
                    program.process.kill()
        self.folder.cleanup()

    # Judgement.

    def wrong(self, text):
        self.problems.append(text)

    def expect(self, value, expected, what):
        if value != expected:
            self.wrong(f"{what} is {value}, not {expected}")

    def require(self, by, name, **members):
        """Waits for an event of this step, without which the demonstration cannot continue."""
        found = self.log.wait_for(lambda: self.log.find(by, name, self.step_begin, **members))
        if not found:
            raise Failed(f"{names[by]} did not log '{name}' within {wait_limit} seconds")
        return found[0]

    def says(self, by, name, **members):
        """Expects an event of this step."""
        if not self.log.wait_for(lambda: self.log.find(by, name, self.step_begin, **members)):
            self.wrong(f"{names[by]} did not log '{name}' with {members}")

    def accepted(self, by):
        """The unit's command of this step is to be in force."""
        for event in self.log.find(by, "message_sent", self.step_begin, code=set_wrench_effort):
            self.efforts.update(efforts_of(from_hexadecimal(event["body"])))

    def held(self):
        """The efforts that the arm has shown last."""
        shown = self.log.find("robot_arm", "efforts_in_force")
        return {axis: shown[-1].get(axis) for axis in axes} if shown else {}

    def arm_holds_that(self):
        self.log.wait_for(lambda: self.held() == self.efforts)
        held = self.held()
        for axis in axes:
            if held.get(axis) != self.efforts[axis]:
                self.wrong(f"the arm has {axis} at {held.get(axis)}, commanded was {self.efforts[axis]}")

    # Output.

    def show_log(self):
        """What all programs have logged since the last call, ordered by time. Fields of headers are in the line above them."""
        with self.log.changed:
            events = sorted(self.log.events[self.printed:], key=lambda event: event["time"])
            self.printed = len(self.log.events)
        colours = {"a": "cyan", "c": "magenta", "robot_controller": "yellow", "robot_arm": "green",
                   "six": "yellow", "drives": "green"}
        header_field = re.compile(r"  000[0-9a-e]  .{14}(priority|command_code|destination\.|source\.|data_size|sequence_number)")
        for event in events:
            lines = [line for line in event["text"].split("\n") if not header_field.match(line)]
            prefix = f"{event['time'] - self.log.begin:7.3f}  {names[event['by']]:<10}  "
            for line in lines:
                print(paint(prefix, colours[event["by"]]) + line)
                prefix = " " * len(prefix)

    def step(self, title, perform, same_events=False):
        """Performs a step and prints its verdict; with `same_events` it judges those of the step before."""
        self.steps += 1
        self.problems = []
        if not same_events:
            self.step_begin = len(self.log.events)
        if self.options.verbose:
            print(f"\n{paint('=== ' + title, 'bold')}")
        try:
            perform()
        except Failed as error:
            self.wrong(str(error))
            raise
        finally:
            if not isinstance(sys.exc_info()[1], KeyboardInterrupt):
                self.show_verdict(title)

    def show_verdict(self, title):
        if self.options.verbose or self.problems:
            time.sleep(0.1)  # for what the programs still log
            self.show_log()
        self.printed = len(self.log.events)
        print(f"{paint('WRONG', 'red') if self.problems else paint('ok', 'green') + '   '} {self.steps:3}  {title}")
        for problem in self.problems:
            print(paint(f"           {problem}", "red"))
        self.failures += bool(self.problems)

    def show_forms(self):
        """The command of the last step in its four forms, field by field; fields of one kind have one colour."""
        command = self.require("a", "message_sent", code=set_wrench_effort)
        packet = self.require("robot_controller", "packet_translated")
        frame = self.require("robot_controller", "sdo_sent", subindex=packet["subindex"], kind="request")
        message = self.require("robot_arm", "message_received", code=set_wrench_effort)
        data = from_hexadecimal(packet["data"])
        wire = from_hexadecimal(frame["text"].split("\n")[-1].strip())[-len(data):]
        instance = re.search(r"ulDestId = \d+", packet["text"])

        rows = []

        def row(colour, name, *cells):
            rows.append((colour, name, *map(str, cells)))

        def row_of_rest(colour, name, length, first, last):
            """A field that is in the data."""
            row(colour, name, first, hexadecimal(data[row_of_rest.at:row_of_rest.at + length]),
                hexadecimal(wire[row_of_rest.at:row_of_rest.at + length]), last)
            row_of_rest.at += length

        row_of_rest.at = 0
        (subsystem, node, component, number), (own_subsystem, own_node, own_component, own_number) = (
            event["destination"].split(".") for event in (command, message))
        size, size_again = (event["size"] - 16 for event in (command, message))  # without the header
        row("cyan", "node", node, f"ulNodeId = {packet['node_id']}", f"station {frame['station']}", own_node)
        row("cyan", "component", component, f"ulIndex = {packet['index']}", f"index {frame['index']}", own_component)
        row("yellow", "command code", f"{command['code']:04X}h", f"ulSubIndex = {packet['subindex']}",
            f"subindex {frame['subindex']}", f"{message['code']:04X}h")
        row("blue", "size of data", "", f"ulDataCnt = {packet['data_count']}", f"{len(wire)} bytes", "")
        if self.options.table == "seed":
            row("cyan", "subsystem", subsystem, f"ulDest = {packet['dest']}", "(that of the arm)", own_subsystem)
            row("cyan", "instance", number, instance[0] if instance else "ulDestId", "(that of the arm)", own_number)
            row("blue", "size of body", size, "(ulDataCnt - 8)", "(size - 8)", size_again)
        row_of_rest("magenta", "properties", 2, f"acknowledge: {command['acknowledgement']}", f"acknowledge: {message['acknowledgement']}")
        if self.options.table != "seed":
            row_of_rest("cyan", "instance", 1, number, own_number)
            row_of_rest("cyan", "subsystem", 1, subsystem, own_subsystem)
        row_of_rest("magenta", "source", 4, command["source"], message["source"])
        if self.options.table != "seed":
            row_of_rest("blue", "size of body", 2, size, size_again)
        row_of_rest("magenta", "sequence number", 2, command["sequence"], message["sequence"])

        body, body_again = (from_hexadecimal(event["body"]) for event in (command, message))
        row_of_rest("green", "presence vector", 2, hexadecimal(body[:2]), hexadecimal(body_again[:2]))
        efforts, efforts_again = efforts_of(body), efforts_of(body_again)
        for axis, raw in efforts.items():
            cells = [f"{percent(axis, each):.2f} %" if each is not None else "-" for each in (raw, efforts_again.get(axis))]
            row_of_rest("green", axis, 2 if axis in axes[:6] else 1, *cells)

        heads = [("bold", "", "JAUS command", "SDO packet", "EtherCAT object", "JAUS message again"),
                 ("faint", command["message"], "unit a sends", "controller makes", "controller writes", "arm executes")]
        print()
        for colour, name, *cells in heads + rows:
            print(f"  {name:<29}" + paint("".join(f"{cell:<21}" for cell in cells).rstrip(), colour))
        print()
        self.expect(hexadecimal(wire), hexadecimal(data), "the data of the object")
        for member in ("code", "source", "destination", "acknowledgement", "sequence", "size", "body"):
            self.expect(message[member], command[member], f"'{member}' of the message that the arm executes")

    # The steps.

    def run(self):
        a, c, arm = "1.1.32.1", "3.1.32.1", "2.2.33.1"
        print(f"Units a ({a}) and c ({c}), a robot controller and its arm ({arm}); table: {self.options.table}")

        def starts():
            self.start_robot("robot_arm")
            self.start_robot("robot_controller")
            self.arm_holds_that()

        def refused(by, controller, authority):
            self.says(by, "message_refused", code=set_wrench_effort)
            self.says(by, "robot_controlled_by", address=arm, controller=controller, authority=authority)
            self.arm_holds_that()

        def commands_without_control():
            self.unit(0, "a", "--no-control", "propulsive_linear_effort_x=10")
            self.accepted("a")
            self.arm_holds_that()

        holding = {}

        def takes_control():
            holding["a"] = self.hold("a", "--authority", "100", "propulsive_linear_effort_x=50", "resistive_linear_effort_x=12.5")
            self.require("a", "report_compared", equal=True)
            self.accepted("a")
            self.arm_holds_that()

        def hears():
            if not self.log.wait_for(lambda: self.log.find("a", "robot_heard", address="2.2.1.1")):
                self.wrong("ocu a has not logged 'robot_heard' with the address 2.2.1.1")

        def is_refused():
            self.unit(1, "c", "--no-control", "propulsive_linear_effort_x=-20")
            refused("c", a, 100)

        def asks_in_vain():
            self.unit(1, "c", "--authority", "50", "propulsive_linear_effort_x=-20")
            self.says("c", "control_refused", address=arm)
            self.arm_holds_that()

        def takes_over():
            holding["c"] = self.hold("c", "--authority", "200", "propulsive_linear_effort_x=25", "propulsive_rotational_effort_z=-33.3")
            self.expect(holding["a"].wait(), 0, "exit code of ocu a")
            self.says("a", "control_lost", address=arm)
            self.accepted("c")
            self.arm_holds_that()

        def is_refused_too():
            self.unit(1, "a", "--no-control", "propulsive_linear_effort_x=99")
            refused("a", c, 200)

        def stops():
            self.unit(0, "a", "--send", "set_emergency", "emergency_code=transition_to_emergency")
            self.says("robot_arm", "efforts_zeroed", cause="emergency")
            self.efforts = dict.fromkeys(axes, 0)
            self.arm_holds_that()

        def clears():
            self.unit(0, "a", "--send", "clear_emergency", "emergency_code=clear_emergency")
            self.says("robot_controller", "state_changed", address=arm, to="standby")

        def releases():
            self.expect(holding["c"].end(), 0, "exit code of ocu c")
            self.says("c", "control_released", address=arm)
            self.says("robot_controller", "controller_gone", address=arm)

        def resumes():
            self.unit(0, "a", "--send", "resume")
            self.says("robot_controller", "state_changed", address=arm, to="ready")

        def commands(*arguments):
            self.unit(0, "a", *arguments)
            self.says("a", "report_compared", equal=True)
            self.accepted("a")
            self.arm_holds_that()

        def queries():
            self.unit(0, "c", "--query")
            reports = self.log.find("c", "message_received", self.step_begin, code=0x4405)
            self.expect([efforts_of(from_hexadecimal(report["body"])) for report in reports], [self.efforts], "the report")

        def ends():
            for name in ("robot_controller", "robot_arm"):
                for program in self.programs:
                    if program.name == name:
                        self.expect(program.end(), 0, f"exit code of the {names[name]}")
                if name == "robot_controller":
                    self.efforts = dict.fromkeys(axes, 0)
                    self.arm_holds_that()

        def six_start():
            self.start_command("drives", "emulated_drives", f"udp:127.0.0.1:{self.drives_port}")
            self.start("six", "robot_controller", "--this", "d", "--cycle", "100000", *patience)
            self.require("six", "ready", slave_up=True)
            self.require("six", "state_changed", address="4.2.54.1", to="ready")
            for joint in joints:
                if not any(f'slave "{joint}"' in event["line"] for event in self.log.find("six", "bus_log", self.step_begin)):
                    self.wrong(f"the controller did not find the slave {joint}")

        def joints_move():
            goal = [0.5, -0.5, 1.0, -1.0, 0.25, 0.1]
            fields = [f"joint[{i}].joint_position={angle}" for i, angle in enumerate(goal)]
            mover = self.hold("a", "--to", "4.2.54.1", "--send", "set_joint_positions", *fields)
            shown, end = [], time.monotonic() + wait_limit

            def are_there():
                return len(shown) == len(goal) and all(abs(a - b) <= 0.02 for a, b in zip(shown, goal))

            while not are_there() and time.monotonic() < end:
                self.unit(0, "c", "--to", "4.2.54.1", "--send", "query_joint_positions")
                reports = self.log.find("c", "message_received", self.step_begin, code=report_joint_positions)
                shown = positions_of(from_hexadecimal(reports[-1]["body"])) if reports else []
            if not are_there():
                self.wrong(f"the joints are at {[round(each, 2) for each in shown]}, commanded was {goal}")
            self.expect(mover.end(), 0, "exit code of unit a")

        def six_end():
            for program in self.programs:
                if program.name == "six":
                    self.expect(program.end(), 0, "exit code of the controller")

        full = ([f"propulsive_linear_effort_{axis}=100" for axis in "xy"] + ["propulsive_linear_effort_z=-100"]
                + [f"propulsive_rotational_effort_{axis}=-100" for axis in "xyz"] + [f"resistive_linear_effort_{axis}=100" for axis in "xyz"]
                + [f"resistive_rotational_effort_{axis}=0" for axis in "xyz"])
        self.step("the robot starts: all efforts are zero", starts)
        self.step("no unit has control: the arm executes a command of unit a", commands_without_control)
        self.step("unit a takes control with authority 100 and commands; the report equals the command", takes_control)
        self.step("the arm executes the message that unit a sent", self.show_forms, same_events=True)
        self.step("unit a receives the robot's heartbeats", hears)
        self.step("unit c commands: refused, because a has control", is_refused)
        self.step("unit c requests control with authority 50: refused", asks_in_vain)
        self.step("unit c takes control with authority 200 and commands; unit a is notified", takes_over)
        self.step("unit a commands: refused, because c has control", is_refused_too)
        self.step("unit a sets an emergency, which needs no control: the arm stops", stops)
        self.step("unit a clears its emergency: the arm is in Standby", clears)
        self.step("unit c releases control", releases)
        self.step("unit a takes control and resumes the arm", resumes)
        self.step("unit a commands full scale on every axis", lambda: commands(*full))
        self.step("unit a commands random fields", lambda: commands("--random", str(random.randrange(32768))))
        self.step("unit c queries: the report has what the arm executes", queries)
        self.step("the robot ends: the controller brings the arm to rest", ends)
        self.step("six drives on one ring: a controller finds each by its name", six_start)
        self.step("unit a commands the positions of six joints, and the drives reach them", joints_move)
        self.step("the controller brings the six drives to rest and ends", six_end)


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--table", choices=("seed", "self-contained"), default="seed")
    parser.add_argument("--verbose", action="store_true")
    parser.add_argument("bin", help="folder of the programs")
    sys.stdout.reconfigure(line_buffering=True)
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    demonstration = Demonstration(parser.parse_args())
    try:
        demonstration.run()
    except KeyboardInterrupt:
        signal.signal(signal.SIGINT, signal.SIG_IGN)
        print("\ndemo: interrupted", file=sys.stderr)
        return 130
    except BrokenPipeError:  # the reader of the output has ended, such as `less`
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return 1
    except Failed:
        pass
    finally:
        demonstration.end()
    print()
    if demonstration.failures:
        print(paint(f"demo: FAILED: {demonstration.failures} of {demonstration.steps} steps", "red"), file=sys.stderr)
        return 1
    print(paint(f"demo: OK: {demonstration.steps} steps as expected; the arm executed exactly what was commanded", "green"))
    return 0


if __name__ == "__main__":
    sys.exit(main())
