"""The examples, as they are run by hand."""
import csv
import io
import os
import pathlib
import signal
import subprocess
import sys
import xml.etree.ElementTree as xml

import pytest
from ports import configuration

examples = pathlib.Path(os.environ["JAUSCAT_EXAMPLES"])
capture = pathlib.Path(os.environ["JAUSCAT_TEST_DATA"]) / "jaus_ra.pcap"


def run(name, *arguments, **options):
    return subprocess.run([sys.executable, examples / name, *map(str, arguments)], capture_output=True, text=True, timeout=120,
                          **options)


def test_the_messages_of_the_document_print_what_it_says():
    code = examples.parents[1] / "docs/code"
    done = subprocess.run([sys.executable, code / "python_messages.py"], capture_output=True, text=True, timeout=120)
    assert done.stdout == (code / "python_messages.txt").read_text(), done.stderr


@pytest.fixture
def vehicle(tmp_path):
    """The configuration of a fake vehicle that runs."""
    config = tmp_path / "JausConfig.xml"
    config.write_text(configuration(robot="2.2.0.0"))
    process = subprocess.Popen([sys.executable, examples / "fake_vehicle.py", "--config", config], stdout=subprocess.PIPE, text=True)
    line = process.stdout.readline()
    assert "Ctrl-C" in line, line
    yield config
    process.send_signal(signal.SIGINT)
    assert process.wait(timeout=60) == 0


def test_a_command_reaches_the_fake_vehicle(vehicle):
    done = run("send_a_command.py", "--config", vehicle, "2.2.33.1", 50)
    assert (done.stdout, done.returncode) == ("in force: 50.002 %\n", 0), done.stderr


def test_a_command_that_is_out_of_range_says_so(vehicle):
    done = run("send_a_command.py", "--config", vehicle, "2.2.33.1", 200)
    assert done.returncode == 1 and "must be -100 to 100 %" in done.stderr


def test_the_fake_vehicle_passes_the_tests_of_a_vehicle(vehicle):
    done = subprocess.run([sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", examples / "test_vehicle.py"],
                          capture_output=True, text=True, timeout=120, env={**os.environ, "VEHICLE_CONFIG": str(vehicle)})
    assert done.returncode == 0 and "3 passed" in done.stdout, done.stdout


def test_the_messages_of_a_capture_become_rows():
    done = run("capture_to_rows.py", capture)
    rows = list(csv.DictReader(io.StringIO(done.stdout)))
    speeds = [row for row in rows if row["message"] == "set_travel_speed"]
    assert [row["field"] for row in speeds] == ["desired_speed"]
    assert len({(row["time"], row["source"]) for row in rows if row["message"] == "report_velocity_state"}) == 75
    assert run("capture_to_rows.py", __file__).stderr.endswith("is no pcap file\n")


def test_a_field_of_a_capture_is_drawn():
    done = run("plot.py", capture, "report_velocity_state", "velocity_x")
    picture = xml.fromstring(done.stdout)
    line = picture.find("{http://www.w3.org/2000/svg}polyline")
    assert len(line.get("points").split()) == 75
    done = run("plot.py", capture, "report_velocity_state", "velocity")
    assert done.returncode == 1 and "it has velocity_x, velocity_y" in done.stderr
