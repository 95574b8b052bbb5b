# Tests of a vehicle, for pytest. VEHICLE_CONFIG is the configuration of the test bench.
import os

import jauscat
import pytest

driver, sensor = "2.2.33.1", "2.2.42.1"


# [test]
@pytest.fixture
def bench():
    node = jauscat.Node(os.environ["VEHICLE_CONFIG"])
    component = node.component(id=32, name="test bench")
    with node:
        yield component


def velocity(bench):
    return bench.ask(sensor, "query_velocity_state", {"presence_vector": 1})["velocity_x"]


def test_the_vehicle_drives_as_it_is_told(bench):
    with bench.control(driver) as control:
        control.send("set_wrench_effort", {"propulsive_linear_effort_x": 50})
        assert velocity(bench) == pytest.approx(5, abs=0.01)


def test_the_vehicle_stops_when_control_ends(bench):
    with bench.control(driver) as control:
        control.send("set_wrench_effort", {"propulsive_linear_effort_x": 50})
    assert velocity(bench) == pytest.approx(0, abs=0.01)


def test_the_vehicle_is_ready_and_refuses_what_its_components_do_not_know(bench):
    assert bench.ask(driver, "query_component_status")["primary_status_code"] == 1 # ready
    with pytest.raises(jauscat.RefusedError):
        bench.send(sensor, "set_wrench_effort", {"propulsive_linear_effort_x": 50})
# [test end]
