"""Sweeps: every point once, failures in the table, and going on after a stop."""

import os
import signal
import subprocess
import sys
import time

import numpy as np
import pytest

import puadem


@pytest.fixture
def case(beads):
    return beads.packing().case({"kind": "retention", "path": [0, 1000], "step": 100}, fluids={"surface_tension": 0.07})


def test_a_product_has_every_combination():
    assert puadem.product({"a": [1, 2], "b": "xy"}) == [
        {"a": 1, "b": "x"}, {"a": 1, "b": "y"}, {"a": 2, "b": "x"}, {"a": 2, "b": "y"}]


def test_each_row_is_the_run_at_its_point(case, workplace):
    points = puadem.product({"fluids.surface_tension": [0.05, 0.07], "fluids.contact_angle": ["0 deg", "20 deg"]})
    table = puadem.sweep(case, points, "study", jobs=2)
    assert table["outcome"].tolist() == ["ok"] * 4
    assert table["fluids.surface_tension"].tolist() == [0.05, 0.05, 0.07, 0.07]
    for row, point in zip(table, points):
        alone = case.with_keys(point).run()
        assert row["saturation_end_drainage-1"] == alone.results["saturation_end_drainage-1"]
        assert puadem.Run(os.path.join("study", row["folder"])).manifest["state_hash"] == alone.manifest["state_hash"]


def test_what_is_done_is_not_done_again(case, workplace):
    points = puadem.product({"fluids.surface_tension": [0.05, 0.07]})
    first = puadem.sweep(case, points[:1], "study")
    manifest = workplace / "study" / first["folder"][0] / "manifest.json"
    kept = manifest.stat().st_mtime_ns
    table = puadem.sweep(case, points, "study")
    assert len(table) == 2
    assert table["saturation_end_drainage-1"][0] == first["saturation_end_drainage-1"][0]
    assert table["error"].tolist() == ["", ""]
    assert manifest.stat().st_mtime_ns == kept


def test_points_that_fail_stand_in_the_table(case, workplace):
    points = puadem.product({"fluids.contact_angle": ["0 deg", "200 deg"]})
    table = puadem.sweep(case, points, "study")
    assert table["outcome"].tolist() == ["ok", "wrong input"]
    assert "contact_angle" in table["error"][1]
    assert np.isnan(table["pores"][1])
    bounds = case.with_keys({"expected.pores": {"max": 1}})
    table = puadem.sweep(bounds, [{"fluids.contact_angle": 0}], "study")
    assert table["outcome"].tolist() == ["failed"]
    assert "expected" in table["error"][0]


def test_points_must_have_the_same_keys(case):
    with pytest.raises(puadem.InputError, match="same keys"):
        puadem.sweep(case, [{"a": 1}, {"b": 1}], "never")


SCRIPT = """
import puadem
puadem.sweep(puadem.Case.from_file("home/case.toml"), [{"stage.0.step": %s}], "study")
"""


def test_a_sweep_goes_on_after_ctrl_c(case, workplace):
    home = workplace / "home"
    home.mkdir()
    for file in case.path.parent.iterdir():
        (home / file.name).write_text(file.read_text())
    step = 1
    python = subprocess.Popen([sys.executable, "-c", SCRIPT % step], stderr=subprocess.PIPE, text=True)
    while not list((workplace / "study").glob("*/series/retention.csv")):
        assert python.poll() is None
        time.sleep(0.002)
    python.send_signal(signal.SIGINT)
    assert "KeyboardInterrupt" in python.communicate()[1]
    place = next((workplace / "study").iterdir())
    assert puadem.Run(place).interrupted
    table = puadem.sweep(puadem.Case.from_file(home / "case.toml"), [{"stage.0.step": step}], "study")
    assert table["outcome"].tolist() == ["ok"] and table["folder"].tolist() == [place.name]
    whole = case.with_keys({"stage.0.step": step}).run()
    assert puadem.Run(place).manifest["state_hash"] == whole.manifest["state_hash"]
