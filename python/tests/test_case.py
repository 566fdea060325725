"""Cases: checked and run as by the program itself, with exceptions for its exit codes."""

import os
import pathlib
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import puadem
from puadem.case import toml
from puadem.program import program

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"
TINY = CASES / "drainage-beads" / "tiny.toml"


def test_a_run_is_that_of_the_program_to_the_last_bit(beads, tmp_path):
    subprocess.run([program(), "run", str(TINY), "--output", str(tmp_path / "shell"), "--quiet"], check=True)
    assert beads.manifest["state_hash"] == puadem.Run(tmp_path / "shell").manifest["state_hash"]


def test_without_an_output_the_results_are_in_runs(workplace):
    run = puadem.Case.from_file(TINY).with_keys({"grains.count": 250, "expected": {}}).run()
    assert run.path.parent == workplace / "runs"
    assert run.results["grains"] == 250


def test_keys_change_a_new_case_only():
    case = puadem.Case.from_file(TINY)
    assert "grains  150 of" in case.with_keys({"grains.count": 150}).check()
    assert "grains  300 of" in case.check()
    assert "grains  160 of" in case.with_keys({"grains.count": 150}).with_keys({"grains.count": 160}).check()


def test_input_errors_name_place_and_nearest_word():
    with pytest.raises(puadem.InputError, match='did you mean "count"') as caught:
        puadem.Case.from_file(TINY).with_keys({"grains.cuont": 3}).run("never")
    assert not str(caught.value).startswith("error")
    with pytest.raises(puadem.InputError, match='did you mean "triaxial"'):
        puadem.Case.from_template("triaxal", "never")
    assert not os.path.exists("never")


def test_results_outside_their_bounds_are_an_error_that_holds_the_run(workplace):
    with pytest.raises(puadem.NumericalError, match="expected") as caught:
        puadem.Case.from_file(TINY).with_keys({"expected.grains": {"max": 1}}).run("failed")
    assert caught.value.run.path == workplace / "failed"
    assert caught.value.run.results["grains"] == 300


def test_templates_are_the_shipped_cases(workplace):
    assert "drainage-beads" in puadem.templates()
    case = puadem.Case.from_template("drainage-beads", "mine")
    assert "grains  5000 of" in case.check()


def test_values_become_toml():
    assert toml({"a": [1, 2.5, "x y"], "b": True}) == '{ a = [1, 2.5, "x y"], b = true }'
    assert toml(np.array([0.1, 1e-300])) == "[0.1, 1e-300]"
    assert toml({"drainage-1": np.float64(3)}) == "{ drainage-1 = 3.0 }"
    assert toml({"two words": 1}) == '{ "two words" = 1 }'
    with pytest.raises(TypeError, match="None"):
        toml(None)


def small_steps(packing, step):
    """Imbibition in small pressure steps [Pa], each a place to go on from."""
    return packing.case({"kind": "retention", "path": [1000, 0], "step": step}, fluids={"surface_tension": 0.07})


def test_an_interrupted_run_goes_on_to_the_same_end(beads, workplace):
    case = small_steps(beads.packing(), 2)
    whole = case.run("whole")
    run = case.run("parts", time_limit=0.05)
    assert run.interrupted
    run = run.resume()
    assert not run.interrupted
    assert run.manifest["state_hash"] == whole.manifest["state_hash"]


SCRIPT = """
import puadem
try:
    puadem.Case.from_file("packing/case.toml").run("stopped")
except KeyboardInterrupt:
    print("interrupted:", puadem.Run("stopped").interrupted)
"""


def test_ctrl_c_leaves_a_run_that_can_go_on(beads, workplace):
    (workplace / "packing").mkdir()
    case = small_steps(beads.packing(), 0.01)  # far longer than it may run
    for file in case.path.parent.iterdir():
        (workplace / "packing" / file.name).write_text(file.read_text())
    python = subprocess.Popen([sys.executable, "-c", SCRIPT], stdout=subprocess.PIPE, text=True)
    while not (workplace / "stopped" / "series" / "retention.csv").exists():
        assert python.poll() is None
        time.sleep(0.005)
    python.send_signal(signal.SIGINT)
    assert python.communicate()[0] == "interrupted: True\n"
