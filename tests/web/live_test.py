#!/usr/bin/python3
"""live_test.py [--page FILE] [--programs FOLDER] [--pictures FOLDER] [NAME...]

Tests the live view of the page in a real browser, with a robot arm, its controller and an operator that run. NAME: a part of the
names of the tests to run; all of them without.

  tests/web/live_test.py --programs build/release/bin arm

Exit code: 0 all passed, 1 a test failed, 2 wrong command line.
"""
import argparse
import json
import math
import pathlib
import signal
import socket
import subprocess
import sys
import tempfile
import threading

from selenium.webdriver.common.keys import Keys

sys.dont_write_bytecode = True
from browser import contrast, longest_wait, page, root, run_tests, test, unnamed_controls # noqa: E402

sys.path.insert(0, str(root / "scripts"))
from free_ports import free_ports # noqa: E402

token = "a-token-of-the-test"


class program:
    """A program that logs JSON, a line each event."""

    def __init__(self, *command):
        self.command = [str(word) for word in command]
        self.process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        self.lines = []
        self.more = threading.Condition()
        self.reader = threading.Thread(target=self.read, daemon=True)
        self.reader.start()

    def read(self):
        for line in self.process.stdout:
            with self.more:
                self.lines.append(line)
                self.more.notify_all()

    def wait_for_line(self, part):
        self.wait(lambda line: part in line, part)

    def wait_for(self, event, **values):
        def has(line):
            try:
                found = json.loads(line)
            except ValueError:
                return False
            return found.get("event") == event and all(found.get(key) == value for key, value in values.items())

        self.wait(has, f"event {event} {values}")

    def wait(self, fits, what):
        with self.more:
            if not self.more.wait_for(lambda: any(fits(line) for line in self.lines), longest_wait):
                raise AssertionError(f"{self.command}: no {what} in\n{''.join(self.lines)[-3000:]}")

    def say(self, text):
        self.process.stdin.write(text + "\n")
        self.process.stdin.flush()

    def end(self, number=signal.SIGTERM):
        if self.process.poll() is None:
            self.process.send_signal(number)
        try:
            return self.process.wait(longest_wait)
        except subprocess.TimeoutExpired:
            self.process.kill()
            raise


class robot:
    """An arm, its controller and an operator on loopback ports of their own. What a test has stopped, the next one starts again."""

    def __init__(self, bin, page):
        self.bin, self.page = bin, page
        self.folder = tempfile.TemporaryDirectory()
        self.config = pathlib.Path(self.folder.name) / "JausConfig.xml"
        *ports, self.slave_port = free_ports(4)
        self.web_port, self.bare_port = free_ports(2, socket.SOCK_STREAM)
        self.config.write_text("<jausconfig>\n  <thissystem>a</thissystem>\n" + "".join(
            f"  <system><name>{name}</name><jausip>{number}.0.0.0</jausip><ip>127.0.0.1</ip><port>{port}</port></system>\n"
            for number, (name, port) in enumerate(zip("abc", ports), 1)) + "</jausconfig>\n")
        self.running = {}

    def start(self, name, *arguments, key=None):
        key = key or name
        one = self.running.get(key)
        if not one or one.process.poll() is not None:
            one = self.running[key] = program(self.bin / name, "--config", self.config, *arguments, "--log-format", "json")
        return one

    def arm(self):
        one = self.start("robot_arm", "--this", "b", "--ethercat-port", self.slave_port, "--command-timeout", 20000)
        one.wait_for("ready")
        return one

    def controller(self):
        one = self.start("robot_controller", "--this", "b", "--ethercat-port", self.slave_port, "--frame-timeout", 100, "--cycle", 10000,
                         "--stop-within", 2000, "--web", self.web_port, "--web-token", token, "--web-page", self.page)
        one.wait_for("ready")
        return one

    def all(self):
        self.arm()
        self.controller().wait_for("state_changed", address="2.2.33.1", to="ready")

    def command(self, **fields):
        """Commands efforts, and keeps control."""
        self.stop("ocu")
        one = self.start("ocu", "--this", "a", "--hold", 600, *(f"{name}={value}" for name, value in fields.items()))
        one.wait_for("holding")

    def joints(self, code, angles):
        """Sends a message with joint positions from system c, as they are on the wire."""
        turn = 8 * math.pi
        body = bytes([len(angles)]) + b"".join(round((angle + turn) / (2 * turn) * 0xFFFFFFFF).to_bytes(4, "little") for angle in angles)
        self.start("communicator", "--this", "c", "--unacknowledged").say(f"send 2.2.33.1 {code:04X} hex={body.hex()}")

    def stop(self, key, number=signal.SIGTERM):
        one = self.running.pop(key, None)
        return one.end(number) if one else None

    def link(self):
        return f"http://127.0.0.1:{self.web_port}/?token={token}"

    def end(self):
        for key in reversed(list(self.running)): # the controller before its arm
            self.stop(key)
        self.folder.cleanup()


class six_joints(robot):
    """An arm of six drives, slow enough to be watched, and its controller."""

    def __init__(self, bin, page):
        super().__init__(bin, page)
        names = "base shoulder elbow wrist_1 wrist_2 wrist_3"
        text = self.config.read_text().replace("<jausip>2.0.0.0", "<jausip>2.1.0.0")
        first, rest = text.split("<name>b</name>")
        rest = rest.replace("</system>", f"""
    <ethercat interface="udp:127.0.0.1:{self.slave_port}">
""" + "".join(f'      <slave name="{name}" position="{i}"/>\n' for i, name in enumerate(names.split())) + f"""    </ethercat>
    <component id="54" slaves="{names}"/>
  </system>""", 1)
        self.config.write_text(first + "<name>b</name>" + rest)

    def all(self):
        drives = self.running["drives"] = program(self.bin / "emulated_drives", f"udp:127.0.0.1:{self.slave_port}")
        drives.wait_for_line("six drives")
        self.start("robot_controller", "--this", "b", "--frame-timeout", 100, "--cycle", 10000, "--stop-within", 3000, "--joint-velocity", 0.25, "--joint-acceleration", 2,
                   "--web", self.web_port, "--web-token", token, "--web-page", self.page).wait_for("state_changed", address="2.1.54.1", to="ready")

    def move(self):
        """Starts to move the joints to 0.5, -0.5, 1, -1, 0.25 and 0.1 radians."""
        self.running["move"] = program(self.bin / "move_joints", "--config", self.config, "--this", "a")
        return self.running["move"]


def watch(p):
    """Opens the page that the controller serves, until it is connected."""
    p.robot.all()
    p.driver.get("about:blank")
    p.driver.get(p.robot.link())
    connected(p)


def connected(p):
    p.until(lambda: p.run("return document.querySelector('#live').dataset.state") == "connected", "not connected")


def rows(p, table):
    """The texts of a table's cells."""
    return p.run("return [...document.querySelectorAll(arguments[0] + ' tbody tr')].map(row => [...row.cells].map(cell => cell.textContent.trim()))", table)


def choose(p, *words, title=None):
    """Chooses the message whose row has these words; it has to pass first. Its title is one of them, or `title`."""
    p.until(lambda: any(all(word in row for word in words) for row in rows(p, "#live-messages")), f"no row with {words}")
    p.run("""[...document.querySelectorAll('#live-messages tbody tr')].find(row => arguments[0].every(word => [...row.cells].some(cell => cell.textContent.trim() === word)))
        .querySelector('button').click()""", list(words))
    p.until(lambda: p.text("#live-detail h3") in ([title] if title else words), "not chosen")


def plot(p, field):
    """Clicks a field of the chosen message: at once where it is found, because each update draws the fields anew."""
    p.until(lambda: p.run("const found = document.querySelector(`#live-fields [data-field='${arguments[0]}']`); found?.click(); return Boolean(found);", field), f"no field {field}")


def shows(p, field, value, unit="%"):
    """Waits until the chosen message has this value."""
    p.until(lambda: any(row[0] == field and abs(float(row[1]) - value) < 0.01 and row[2] == unit for row in rows(p, "#live-fields")), f"{field} is not {value}")


def points(p, field):
    return p.run("return Number(document.querySelector(`#live-panels [data-field=\"${arguments[0]}\"]`)?.dataset.points ?? 0)", field)


@test
def a_served_page_begins_with_what_is_there(p):
    watch(p)
    assert p.run("return document.body.dataset.view") == "live"
    assert not p.find("#messages").is_displayed()
    assert "robot_controller" in p.text("#live-program") and "system b" in p.text("#live-program"), p.text("#live-program")
    p.robot.command(propulsive_linear_effort_x=50)
    p.until(lambda: any(row[:2] == ["1", "a"] and row[3] == "alive" for row in rows(p, "#live-systems")), "system a is not alive")
    p.until(lambda: any(row[0] == "2.2.33.1" and row[2] == "ready" and row[3].startswith("1.1.32.1") for row in rows(p, "#live-components")), "no controller")
    assert "own" in next(row for row in rows(p, "#live-components") if row[0] == "2.2.33.1")[1]


@test
def components_are_known_by_their_reports(p):
    """To jausdump, too, which has neither a node nor a configuration."""
    [jaus_port], [web_port] = free_ports(1), free_ports(1, socket.SOCK_STREAM)
    p.robot.stop("jausdump")
    dump = p.robot.running["jausdump"] = program(p.robot.bin / "jausdump", "--listen", jaus_port, "--web", web_port, "--web-page", p.robot.page)
    dump.wait_for_line("live view at")

    def send(code, body):
        """From 2.2.33.1 to 1.1.32.1, by the header of RA 3.3."""
        header = bytes.fromhex("0602") + code.to_bytes(2, "little") + bytes([1, 32, 1, 1, 1, 33, 2, 2]) + len(body).to_bytes(2, "little") + bytes(2)
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as sender:
            sender.sendto(header + body, ("127.0.0.1", jaus_port))

    def component():
        return next((row for row in rows(p, "#live-components") if row[0] == "2.2.33.1"), ["", "", "", "", ""])

    def shown(*values):
        p.until(lambda: all(value in component()[1:4] for value in values), f"not {values}")

    p.driver.get("about:blank")
    p.driver.get(f"http://127.0.0.1:{web_port}/")
    connected(p)
    send(0x4002, bytes([1, 0, 0, 0, 0]))                                 # Report Component Status
    shown("ready")
    assert component()[4].endswith("ago"), component()
    send(0x4002, bytes([5, 0, 0, 0, 0]))
    send(0x400D, bytes([1, 1, 32, 1, 5]))                                # Report Component Control
    send(0x4B00, bytes([4, 0]) + (10001).to_bytes(2, "little") + b"arm") # Report Identification
    shown("arm", "emergency", "1.1.32.1 (authority 5)")
    send(0x400D, bytes(5))
    shown("none")
    p.until(lambda: all(text.startswith(value) and text.endswith(" ago") for text, value in zip(component()[2:4], ["emergency, ", "none, "])), "an old report is shown as new")
    p.robot.stop("jausdump")


@test
def messages_have_rows_with_fields(p):
    watch(p)
    p.robot.command(propulsive_linear_effort_x=25)
    choose(p, "set_wrench_effort", "1.1.32.1")
    shows(p, "propulsive_linear_effort_x", 25, "%")
    assert p.text(".live-hex").replace(" ", "")[4:8] == "0504", p.text(".live-hex")
    # The filter leaves what has all words; sorted by a number, the largest is first.
    p.find("#live-filter").send_keys("wrench 0405h")
    p.until(lambda: {row[2] for row in rows(p, "#live-messages")} == {"set_wrench_effort", "ACK of set_wrench_effort"})
    p.find("#live-filter").clear()
    p.find("#live-filter").send_keys("nothing like that")
    p.until(lambda: p.text("#live-left") == "No message fits the filter.")
    p.run("const box = document.querySelector('#live-filter'); box.value = ''; box.dispatchEvent(new Event('input'));")
    p.until(lambda: len(rows(p, "#live-messages")) > 2)
    p.run("[...document.querySelectorAll('#live-messages thead button')].find(one => one.textContent === 'Count').click()")
    assert p.run("return document.querySelector('#live-messages [aria-sort]').textContent") == "Count"
    p.until(lambda: (lambda counts: counts == sorted(counts, reverse=True))([int(row[6]) for row in rows(p, "#live-messages")]))


@test
def a_message_opens_byte_by_byte(p):
    watch(p)
    p.robot.command(propulsive_linear_effort_x=50)
    choose(p, "set_wrench_effort", "1.1.32.1")
    shows(p, "propulsive_linear_effort_x", 50)
    p.until(lambda: p.find("#live-bytes").is_enabled())
    p.run("document.querySelector('#live-bytes').click()")
    p.until(lambda: p.text("#result h2") == "Set Wrench Effort")
    assert p.find("#messages").is_displayed() and not p.find("#live").is_displayed()
    assert p.run("return shown.fields.propulsive_linear_effort_x.raw") == 16384


@test
def numbers_are_plotted(p):
    watch(p)
    p.robot.command(propulsive_linear_effort_x=10)
    choose(p, "set_wrench_effort", "1.1.32.1")
    shows(p, "propulsive_linear_effort_x", 10)
    plot(p, "propulsive_linear_effort_x")
    p.until(lambda: points(p, "propulsive_linear_effort_x") >= 1)
    for value in (30, -40):
        before = points(p, "propulsive_linear_effort_x")
        while points(p, "propulsive_linear_effort_x") == before: # what comes within 48 ms counts as one
            p.robot.command(propulsive_linear_effort_x=value)
            shows(p, "propulsive_linear_effort_x", value)
    assert p.text("#live-panels").splitlines()[-1] == "%", p.text("#live-panels")
    legend = rows(p, "#live-legend")[0]
    assert abs(float(legend[2]) + 40) < 0.01 and abs(float(legend[3]) - 30) < 0.01, legend
    # A pause holds the picture, and the end of it shows what has come since.
    p.find("#live-pause").click()
    p.until(lambda: p.find("#live-pause").get_attribute("aria-pressed") == "true")
    count = points(p, "propulsive_linear_effort_x")
    for value in (60, 70): # the first may count as one with what was before
        p.robot.command(propulsive_linear_effort_x=value)
        shows(p, "propulsive_linear_effort_x", value)
    assert points(p, "propulsive_linear_effort_x") == count
    p.find("#live-pause").click()
    p.until(lambda: points(p, "propulsive_linear_effort_x") > count)
    p.picture("live-plot")
    p.find("#live-legend button").click()
    p.until(lambda: not rows(p, "#live-legend") and not p.all("#live-panels svg"))


@test
def memory_of_plots_and_faults_is_bounded(p):
    watch(p)
    p.find("#live-connect").click() # from here on the test is the program
    p.until(lambda: p.run("return document.querySelector('#live').dataset.state") == "lost")
    p.run("""
        const row = at => ({id: 900001, generation: 'ra', way: 'seen', code: 'D000h', name: 'many', from: '9.9.9.9', to: '8.8.8.8', count: at, at, size: 2, hex: '00', fields: {x: Math.sin(at), '<b>y</b>': 1}, units: {x: '<i>m</i>'}});
        window.row_of_many = row;
        live.take({at: 1e6, messages: [row(1e6)]});
        for (let i = 0; i !== 700; ++i) live.take({faults: [{at: 1e6, level: 'bad', text: '<img src=x onerror="document.title=1">' + i}]});""")
    choose(p, "many")
    plot(p, "x")
    p.run("for (let i = 1; i !== 20000; ++i) live.take({at: 1e6 + i / 100, messages: [row_of_many(1e6 + i / 100)]});")
    p.until(lambda: points(p, "x") > 1000)
    assert points(p, "x") <= 1280, points(p, "x")
    p.until(lambda: len(p.all("#live-faults li")) == 600)
    assert p.all("#live img") == [] and p.all("#live-fields b") == [] and p.all("#live i") == [], "text has become elements"
    assert p.text("#live-faults li span:last-child").startswith("<img"), p.text("#live-faults li")


@test
def an_acknowledgement_is_shown_as_one(p):
    watch(p)
    p.robot.command(propulsive_linear_effort_x=50)
    choose(p, "ACK of set_wrench_effort", "2.2.33.1", "1.1.32.1", title="acknowledgement of set_wrench_effort")
    assert p.text("#live-detail .facts").endswith(" · ACK"), p.text("#live-detail .facts")
    assert "no fields" in p.text("#live-detail .note"), p.text("#live-detail .note")
    assert not p.find("#live-fields").is_displayed()
    choose(p, "set_wrench_effort", "1.1.32.1", "2.2.33.1")
    shows(p, "propulsive_linear_effort_x", 50)
    assert p.text("#live-detail .facts").endswith(" · wants ACK"), p.text("#live-detail .facts")
    assert not p.find("#live-detail .note").is_displayed()
    # A refusal, and an acknowledgement of SAE JAUS, which names no message.
    p.find("#live-connect").click()
    p.run("""
        const row = {way: 'seen', count: 1, at: 1, size: 16, hex: ''};
        live.take({messages: [{...row, id: 900001, generation: 'ra', code: '0405h', name: 'set_wrench_effort', acknowledgement: 'nak', from: '9.9.9.9', to: '8.8.8.8'},
                              {...row, id: 900002, generation: 'sae', code: '', name: '', acknowledgement: 'ack', from: '300.2.33', to: '1.1.32'}]});""")
    choose(p, "NAK of set_wrench_effort", "9.9.9.9", title="negative acknowledgement of set_wrench_effort")
    assert p.text("#live-detail .facts").endswith(" · NAK"), p.text("#live-detail .facts")
    assert "refused" in p.text("#live-detail .note"), p.text("#live-detail .note")
    choose(p, "ACK", "300.2.33", title="acknowledgement")


@test
def a_bus_has_its_slaves_and_a_dead_arm_is_a_fault(p):
    watch(p)
    p.until(lambda: any(row[3] == "op" for row in rows(p, "#live-buses .slaves")), "no slave in OP")
    facts = p.text("#live-buses dl")
    assert "Working counter" in facts and "Period" in facts, facts
    p.until(lambda: sum(int(row[1]) for row in rows(p, "#live-buses .histogram")) > 10, "no cycle in the histogram")
    p.until(lambda: any(row[5:8] == ["0", "0", "0"] for row in rows(p, "#live-buses .slaves")), "no error counters")
    before = len(p.all("#live-faults li.bad"))
    p.robot.stop("robot_arm", signal.SIGKILL)
    p.until(lambda: len(p.all("#live-faults li.bad")) > before, "no fault of the lost arm")
    p.until(lambda: all(row[3] != "op" or row[8].startswith("no") for row in rows(p, "#live-buses .slaves")), "the slave is still served")
    p.picture("live-fault")
    p.robot.stop("robot_controller")


@test
def joints_are_an_arm(p):
    watch(p)
    commanded, reported = [0.5, -0.25, 1.0], [0.45, -0.2, 0.9]
    p.robot.joints(0x0602, commanded) # to 2.2.33.1
    p.robot.joints(0x4602, reported) # from 3.1.32.1: an arm of its own
    angles = "return (document.querySelector('#live-arm-list g.' + arguments[0])?.dataset.angles ?? '').split(' ').map(Number)"
    near = lambda name, wanted: (lambda found: len(found) == len(wanted) and all(abs(a - b) < 1e-3 for a, b in zip(found, wanted)))(p.run(angles, name))
    p.until(lambda: near("commanded", commanded), "no commanded arm")
    p.until(lambda: near("reported", reported), "no reported arm")
    texts = p.run("return [...document.querySelectorAll('#live-arm-list .arm')].map(arm => [...arm.querySelectorAll('.angle')].map(one => one.textContent).join(' '))")
    assert sorted(texts) == ["25.8° -11.5° 51.6°", "28.6° -14.3° 57.3°"], texts
    assert sorted("".join(row[1:3]) for row in rows(p, "#live-arm-list")) == sorted(" ".join(texts).split())
    moved = [0.1, 0.2, 0.3, 0.4]
    p.robot.joints(0x4602, moved)
    p.until(lambda: near("reported", moved), "the arm has not moved")
    # Of one component both are in one picture, and ten joints are in their order.
    p.find("#live-connect").click()
    p.run("""
        const fields = angles => Object.fromEntries([...angles.keys()].map(String).sort().map(i => [`joint_position.${i}.joint`, angles[i]]));
        const row = {generation: 'ra', way: 'seen', count: 1, at: 1, size: 2, hex: ''};
        live.take({messages: [{...row, id: 900001, name: 'set_joint_positions', from: '1.1.1.1', to: '9.1.54.1', code: '0602h', fields: fields([...arguments[0]])},
                              {...row, id: 900002, name: 'report_joint_positions', from: '9.1.54.1', to: '1.1.1.1', code: '4602h', fields: fields([...arguments[0]].map(one => one / 2))}]});
    """, [i / 10 for i in range(11)])
    both = '#live-arm-list [data-arm="ra 9.1.54.1"] '
    p.until(lambda: len(p.all(both + "g.commanded")) == len(p.all(both + "g.reported")) == 1)
    assert p.run("return document.querySelector(arguments[0]).dataset.angles", both + "g.commanded") == " ".join(f"{i / 10:.4f}" for i in range(11))
    assert rows(p, both)[10][:3] == ["11", "28.6°", "57.3°"], rows(p, both)
    p.picture("live-joints")


@test
def six_joints_move(p):
    before, p.robot = p.robot, six_joints(p.robot.bin, p.robot.page)
    try:
        watch(p)
        arm = '#live-arm-list [data-arm="ra 2.1.54.1"] '
        angles = "return (document.querySelector(arguments[0])?.dataset.angles ?? '').split(' ').map(Number)"
        p.robot.move()
        p.until(lambda: p.run(angles, arm + "g.commanded") == [0.5, -0.5, 1, -1, 0.25, 0.1], "no command")
        seen = []
        p.until(lambda: seen.append(p.run(angles, arm + "g.reported")[-4:]) or abs(seen[-1][0] - 1) < 0.03, "the arm does not arrive")
        assert len({round(one[0], 1) for one in seen if one and len(one) == 4}) > 4, "the arm was not seen on its way"
        p.until(lambda: [row[1] for row in rows(p, "#live-buses .slaves") if row[3] == "op"] == "base shoulder elbow wrist_1 wrist_2 wrist_3".split())
    finally:
        p.robot.end()
        p.robot = before


@test
def a_lost_connection_is_said_and_comes_back(p):
    watch(p)
    p.robot.command(propulsive_linear_effort_x=50)
    choose(p, "set_wrench_effort", "1.1.32.1")
    p.robot.stop("robot_controller")
    p.until(lambda: p.run("return document.querySelector('#live').dataset.state") == "lost")
    assert "lost" in p.text("#live-status"), p.text("#live-status")
    assert rows(p, "#live-messages"), "the last state is gone"
    assert p.run("return getComputedStyle(document.querySelector('#live-shown')).filter") == "grayscale(1)"
    p.robot.controller()
    connected(p)
    p.until(lambda: rows(p, "#live-components"))


@test
def a_suspended_program_is_not_shown_as_live(p):
    watch(p)
    controller = p.robot.controller().process
    controller.send_signal(signal.SIGSTOP)
    try:
        p.until(lambda: p.run("return document.querySelector('#live').dataset.state") == "lost", "its silence is not noticed")
        assert "sent nothing" in p.text("#live-status"), p.text("#live-status")
    finally:
        controller.send_signal(signal.SIGCONT)
    connected(p)
    assert "Connected" in p.text("#live-status"), p.text("#live-status")


@test
def a_page_from_disk_connects_by_the_link(p):
    p.robot.all()
    p.open("view=live")
    assert "Not connected" in p.text("#live-status")
    p.find("#live-address").send_keys("no address", Keys.ENTER)
    p.until(lambda: "is no address" in p.text("#live-status"))
    p.find("#live-address").clear()
    p.find("#live-address").send_keys(p.robot.link(), Keys.ENTER)
    connected(p)
    assert p.find("#live-token").get_attribute("value") == token
    assert p.run("return location.hash") == f"#view=live&address=127.0.0.1%3A{p.robot.web_port}", p.run("return location.hash")
    p.find("#live-connect").click()
    p.until(lambda: p.run("return document.querySelector('#live').dataset.state") == "lost")
    p.find("#live-token").clear()
    p.find("#live-token").send_keys("wrong")
    p.find("#live-connect").click()
    p.until(lambda: "No connection" in p.text("#live-status"))
    p.find("#live-connect").click()


@test
def a_page_without_the_module_has_the_live_view(p):
    bare = p.pictures.parent / "live_only.html"
    subprocess.run(["python3", root / "tools/web/assemble.py", "-", bare], check=True, stdout=subprocess.DEVNULL)
    p.driver.get("about:blank")
    p.driver.get(bare.resolve().as_uri())
    p.until(lambda: p.run("return document.documentElement.dataset.ready") == "true")
    assert p.find("#live").is_displayed() and not p.find("#messages").is_displayed() and not p.find("#tab-messages").is_displayed()
    assert "jauscat.html" in p.text("#without-module")
    p.robot.all()
    p.find("#live-address").send_keys(p.robot.link(), Keys.ENTER)
    connected(p)
    p.robot.command(propulsive_linear_effort_x=50)
    choose(p, "set_wrench_effort", "1.1.32.1")
    assert not p.all("#live-bytes")


@test
def a_program_has_the_page_inside(p):
    p.robot.all()
    p.robot.stop("communicator") # which is system c, too
    one = p.robot.start("ocu", "--this", "c", "--hold", 600, "--query", "--web", p.robot.bare_port, key="bare")
    try:
        one.wait_for("holding")
        p.driver.get("about:blank")
        p.driver.get(f"http://127.0.0.1:{p.robot.bare_port}/")
        connected(p)
        assert "ocu" in p.text("#live-program"), p.text("#live-program")
        p.until(lambda: rows(p, "#live-messages")) # heartbeats
    finally:
        p.robot.stop("bare")


def full(p):
    """A page with something in each part."""
    watch(p)
    p.robot.joints(0x0602, [0.5, -0.25])
    p.robot.joints(0x4602, [0.4, -0.2])
    p.robot.command(propulsive_linear_effort_x=50, propulsive_linear_effort_y=-20)
    choose(p, "set_wrench_effort", "1.1.32.1")
    plot(p, "propulsive_linear_effort_x")
    plot(p, "propulsive_linear_effort_y")
    p.until(lambda: points(p, "propulsive_linear_effort_y") and p.all("#live-arm-list svg") and p.all("#live-buses .slaves tbody tr"))


@test
def the_live_view_has_contrast_in_both_schemes(p):
    full(p)
    for scheme in ("dark", "light"):
        p.scheme(scheme)
        for selector in ("#tab-live", "#tab-messages", "#live-status", "#live-program", "#live-help", "#live caption", "#live thead th", "#live-messages tbody td", "#live-messages .choice",
                         "#live-fields .choice", ".live-hex", "#live-legend .of", "#live-buses dt", "#live .good"):
            assert contrast(p, selector) >= 4.5, (scheme, selector, contrast(p, selector))
        p.picture("live-" + scheme)


@test
def the_live_view_fits_a_narrow_screen(p):
    full(p)
    p.size(320, 640)
    try:
        p.until(lambda: p.run("return document.querySelector('#live-panels svg').getBoundingClientRect().right") <= 320)
        assert p.run("return document.documentElement.scrollWidth") <= 320, p.run("""return [...document.querySelectorAll('body *')]
            .filter(one => one.getBoundingClientRect().right > 320.5 && one.offsetParent && !one.closest('.scroll')).map(one => one.tagName + '.' + one.className)""")
        p.picture("live-narrow")
    finally:
        p.size(1000, 900)


@test
def the_live_view_works_by_the_keyboard_and_for_screen_readers(p):
    full(p)
    seen, unnamed = unnamed_controls(p)
    assert unnamed == [] and seen > 20, (seen, unnamed)
    ids = p.run("return [...document.querySelectorAll('[id]')].map(one => one.id)")
    assert len(ids) == len(set(ids)), sorted(one for one in ids if ids.count(one) > 1)
    assert p.run("return [...document.querySelectorAll('#live table')].filter(one => !one.querySelector('thead th[scope=col]') || one.querySelector('tbody tr') && !one.querySelector('tbody th[scope=row]')).length") == 0
    p.run("document.querySelector('#live-messages .choice[aria-pressed=true]').click(); document.querySelector('#live-messages .choice').focus()")
    p.keys(Keys.END, Keys.HOME, Keys.ENTER)
    p.until(lambda: p.find("#live-detail").is_displayed() and p.run("return document.querySelector('#live-messages tr').contains(document.activeElement) || document.activeElement.matches('#live-messages .choice')"))
    p.keys(Keys.TAB)
    assert p.run("return document.activeElement.closest('#live-detail') !== null || document.activeElement.id !== ''")
    p.run("document.querySelector('#tab-live').focus()")
    p.keys(Keys.ARROW_LEFT, Keys.ENTER)
    p.until(lambda: p.find("#messages").is_displayed())
    p.keys(Keys.ARROW_RIGHT, Keys.ENTER)
    p.until(lambda: p.find("#live").is_displayed())
    # Only the program is asked.
    names = p.run("return performance.getEntriesByType('resource').map(one => one.name)")
    assert names == [], names


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("--page", type=pathlib.Path, default=root / "build/web/jauscat.html")
    parser.add_argument("--programs", type=pathlib.Path, default=root / "build/release/bin")
    parser.add_argument("--pictures", type=pathlib.Path, default=root / "build/web/pictures")
    parser.add_argument("names", nargs="*")
    options = parser.parse_args()
    p = page(options.page, options.pictures)
    p.robot = robot(options.programs.resolve(), options.page.resolve())
    try:
        return run_tests(p, options.names)
    finally:
        p.robot.end()


if __name__ == "__main__":
    sys.exit(main())
