"""Nodes: two of them talk over the loopback interface, on ports that the test picks."""
import os
import queue
import signal
import subprocess
import sys
import threading

import jauscat
import pytest
from ports import configuration

robot = "2.1.33.1"


class pair:
    """Operator 1.1.32.1 and robot 2.1.33.1, which obeys Set Wrench Effort and reports the efforts."""

    def __init__(self):
        self.config = configuration()
        self.log = []
        self.commands = queue.SimpleQueue()
        self.stops = queue.SimpleQueue()
        self.efforts = {}
        self.robots = jauscat.Node(config_text=self.config, this_system="robot", log=self.log.append)
        self.driver = self.robots.component(33, "Primitive Driver")
        self.driver.on("set_wrench_effort", self.command)
        self.driver.on("query_wrench_effort", lambda query: self.efforts)
        self.driver.when_stopped(lambda: self.stops.put(True))
        self.bench = jauscat.Node(config_text=self.config, this_system="operator", log=self.log.append)
        self.operator = self.bench.component(32, "test bench")

    def command(self, message):
        self.efforts = {**{one.name: 0 for one in message.type.fields}, **message.fields}
        self.commands.put(message)

    def __enter__(self):
        self.driver.ready()
        self.robots.start()
        self.bench.start()
        return self

    def __exit__(self, *_):
        self.bench.stop()
        self.robots.stop()


@pytest.fixture
def both():
    with pair() as made:
        yield made


def test_a_command_is_executed_and_acknowledged(both):
    both.operator.send(robot, "set_wrench_effort", {"propulsive_linear_effort_x": 50})
    message = both.commands.get(timeout=20)
    assert message.source == both.operator.address == "1.1.32.1"
    assert message.wants_acknowledgement
    assert message["propulsive_linear_effort_x"] == pytest.approx(50, abs=0.01)


def test_a_query_is_answered_with_the_fields_that_it_asks_for(both):
    both.operator.send(robot, "set_wrench_effort", {"propulsive_linear_effort_x": 50})
    report = both.operator.ask(robot, "query_wrench_effort", {"presence_vector": 3})
    assert list(report.fields) == ["propulsive_linear_effort_x", "propulsive_linear_effort_y"]
    assert report.name == "report_wrench_effort" and report.source == robot
    status = both.operator.ask(robot, "query_component_status")  # the component itself answers
    assert status["primary_status_code"] == 1


def test_a_handler_that_returns_false_refuses(both):
    both.robots.stop()
    both.driver.on("set_travel_speed", lambda message: False)
    both.driver.ready()
    both.robots.start()
    with pytest.raises(jauscat.RefusedError, match="set_travel_speed to 2.1.33.1: refused by the receiver"):
        both.operator.send(robot, "set_travel_speed", {"desired_speed": 1})


def test_an_exception_of_a_handler_refuses_is_logged_and_stops_the_component(both):
    def fails(message):
        raise ValueError("no such gear")

    both.robots.stop()
    both.driver.on("set_travel_speed", fails)
    both.driver.ready()
    both.robots.start()
    with pytest.raises(jauscat.RefusedError):
        both.operator.send(robot, "set_travel_speed", {"desired_speed": 1})
    assert both.driver.state == "failure"
    assert both.stops.get(timeout=20)
    assert any("ValueError: no such gear" in line for line in both.log)


def test_control_is_taken_used_and_released(both):
    with both.operator.control(robot, authority=100) as control:
        assert control.held and both.driver.controller == "1.1.32.1"
        control.send("set_wrench_effort", {"propulsive_linear_effort_x": 10})
        assert both.commands.get(timeout=20)["propulsive_linear_effort_x"] == pytest.approx(10, abs=0.01)
    assert not control.held and both.driver.controller is None
    assert both.stops.get(timeout=20)


def test_no_answer_and_no_route_are_told_apart(both):
    with pytest.raises(jauscat.NoAnswerError):
        both.operator.ask("2.1.99.1", "query_component_status", timeout=0.2, acknowledged=False)
    with pytest.raises(jauscat.NodeError, match="the configuration has no system") as caught:
        both.operator.send("9.1.1.1", "set_travel_speed", {"desired_speed": 1})
    assert not isinstance(caught.value, jauscat.NoAnswerError)
    with pytest.raises(jauscat.NodeError, match="is no query"):
        both.operator.ask(robot, "set_travel_speed", {"desired_speed": 1})


def test_other_threads_of_python_run_while_one_waits(both):
    """A handler in a thread of Python answers only if the waiting one lets it run."""
    done = threading.Event()
    worker = threading.Thread(target=lambda: (both.commands.get(), done.set()))
    worker.start()
    both.operator.send(robot, "set_wrench_effort", {"propulsive_linear_effort_x": 1})
    assert done.wait(20)
    worker.join()


def test_a_handler_may_send_but_does_not_wait_for_an_answer():
    config, found = configuration(), queue.SimpleQueue()
    node = jauscat.Node(config_text=config, this_system="operator", log=lambda line: None)
    unit, other = node.component(32), node.component(40)

    def handler(message):
        try:
            other.send(unit.address, "set_travel_speed", {"desired_speed": 1})
        except RuntimeError as error:
            found.put(str(error))

    other.on("set_wrench_effort", handler)
    other.ready()
    with node:
        unit.send(other.address, "set_wrench_effort", {})
        assert "a handler cannot wait for an answer" in found.get(timeout=20)


def test_what_is_not_running_says_so():
    made = pair()
    with pytest.raises(jauscat.NodeError, match="the node is not running"):
        made.operator.send(robot, "set_travel_speed", {"desired_speed": 1})
    with made:
        assert made.bench.running
        with pytest.raises(RuntimeError, match="the node is running"):
            made.bench.start()
    assert not made.bench.running
    made.bench.stop()


def test_what_other_threads_wait_for_ends_when_the_node_stops():
    """A call that came behind the stop was never done: of 3 threads one hung, at the first stop."""
    bench = jauscat.Node(config_text=configuration(), this_system="operator", log=lambda line: None)
    operator = bench.component(32, "test bench")
    for _ in range(20):
        is_over = threading.Event()

        def ask_for_the_state():
            while not is_over.is_set():
                try:
                    assert operator.state
                except jauscat.NodeError:
                    return

        bench.start()
        threads = [threading.Thread(target=ask_for_the_state, daemon=True) for _ in range(3)]
        for one in threads:
            one.start()
        bench.stop()
        is_over.set()
        for one in threads:
            one.join(timeout=60)
            assert not one.is_alive()


def test_a_wrong_configuration_says_what_to_do(tmp_path):
    with pytest.raises(jauscat.ConfigurationError, match="cannot be read") as caught:
        jauscat.Node(str(tmp_path / "none.xml"))
    assert caught.value.reason == "the file cannot be read"
    with pytest.raises(jauscat.ConfigurationError):
        jauscat.Node(config_text="<jausconfig/>")
    with pair() as first:
        second = jauscat.Node(config_text=first.config, this_system="robot", log=lambda line: None)
        with pytest.raises(jauscat.ConfigurationError):
            second.start()
        assert not second.running
    node = jauscat.Node(config_text=configuration(), this_system="robot")
    node.component(33)
    with pytest.raises(jauscat.ConfigurationError):
        node.component(33)


@pytest.mark.parametrize("program", [
    "node.run()",
    "unit.ask('2.1.33.1', 'query_component_status', timeout=100, acknowledged=False)",
])
def test_ctrl_c_ends_what_waits(program):
    text = f"""import jauscat, sys
node = jauscat.Node(config_text=sys.argv[1], this_system="operator", log=lambda line: None)
unit = node.component(32)
node.start()
try:
    print("waiting", flush=True)
    {program}
except KeyboardInterrupt:
    node.stop()
    print("interrupted, running:", node.running)
"""
    process = subprocess.Popen([sys.executable, "-c", text, configuration()], stdout=subprocess.PIPE, text=True)
    assert process.stdout.readline() == "waiting\n"
    process.send_signal(signal.SIGINT)
    out, _ = process.communicate(timeout=60)
    assert out == "interrupted, running: False\n" and process.returncode == 0


def test_a_program_that_forgets_to_stop_its_node_ends():
    text = """import jauscat, sys
node = jauscat.Node(config_text=sys.argv[1], this_system="operator", log=lambda line: None)
node.component(32).when_stopped(lambda: print("stopped"))
node.start()
"""
    done = subprocess.run([sys.executable, "-c", text, configuration()], stdout=subprocess.PIPE, text=True, timeout=60)
    assert done.returncode == 0 and "stopped" in done.stdout
