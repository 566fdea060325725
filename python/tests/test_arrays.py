"""Packings, networks and results as arrays."""

import numpy as np
import pytest

import puadem

SURFACE_TENSION = 0.0728  # [N/m]


def test_a_packing_reads_back_to_the_same_bits(beads, tmp_path):
    packing = beads.packing()
    packing.write(tmp_path / "copy.csv")
    copy = puadem.Packing.read(tmp_path / "copy.csv")
    assert np.array_equal(copy.position, packing.position)
    assert np.array_equal(copy.radius, packing.radius)
    assert np.array_equal(copy.box, packing.box)


def test_shapes_of_a_packing_are_checked():
    with pytest.raises(puadem.InputError, match=r"\(N, 3\)"):
        puadem.Packing([[0, 0]], [1], [1, 1, 1])


def test_a_wrong_line_of_a_packing_is_named(tmp_path):
    file = tmp_path / "wrong.csv"
    file.write_text("# box 1 1 1\nx,y,z,r\n0.5,0.5,0.5\n")
    with pytest.raises(puadem.InputError, match="wrong.csv:3"):
        puadem.Packing.read(file)


def test_pores_and_grains_fill_the_box(lattice):
    void = 6e-3**3 - 27 * 4 / 3 * np.pi * 1e-3**3
    for merge_ratio in (0.9, None):
        assert lattice.network(merge_ratio).pore["volume"].sum() == pytest.approx(void, rel=1e-12)


def test_throats_join_pores_and_carry_what_openpnm_calls_them(lattice):
    network = lattice.network()
    pores = len(network.pore["volume"])
    assert network.pore["coords"].shape == (pores, 3)
    assert network.throat["conns"].min() >= 0 and network.throat["conns"].max() < pores
    assert network.pore["top"].dtype == bool and network.pore["top"].any() and not network.pore["top"].all()
    assert np.allclose(network.box, 6e-3)


def test_no_pore_drains_below_the_lowest_entry_pressure(beads, workplace):
    packing = beads.packing()
    lowest = SURFACE_TENSION / packing.network().throat["entry_radius"].max()
    curve = packing.retention([0.999 * lowest, "1300 Pa"], step="100 Pa", output="run").series("retention")
    assert np.all(curve["saturation"][curve["pc_Pa"] < lowest] == 1)
    assert curve["saturation"][-1] < 0.5
    assert np.all(np.diff(curve["saturation"]) <= 0)


def test_retention_scales_with_the_surface_tension(beads, workplace):
    packing = beads.packing()
    water = packing.retention([400, 1000], step=100, output="water").series("retention")
    half = packing.retention(["200 Pa", "500 Pa"], step="50 Pa", surface_tension="36.4 mN/m", output="half").series("retention")
    assert half["pc_Pa"] == pytest.approx(water["pc_Pa"] / 2)
    assert half["saturation"] == pytest.approx(water["saturation"], rel=1e-12)


def test_series_are_columns_by_name(beads):
    assert "retention" in beads.series_names
    curve = beads.series("retention")
    drainage = curve[curve["branch"] == "drainage-1"]
    assert drainage["pc_Pa"].tolist() == [400 + 100 * k for k in range(10)]
    assert drainage["saturation"][-1] == beads.results["saturation_end_drainage-1"]
    with pytest.raises(puadem.InputError, match="there are: .*retention"):
        beads.series("retentoin")


def test_fields_hold_the_grains_of_the_packing(beads):
    grains = beads.fields("grains")[-1].read()
    packing = beads.packing()
    assert np.array_equal(grains.points, packing.position)
    assert np.array_equal(grains.point_data["radius"], packing.radius)
    assert not grains.points.flags.writeable


def test_fields_of_pores_add_up_to_the_saturation_of_the_curve(beads):
    frames = beads.fields("pores")
    assert [frame.time for frame in frames] == sorted(frame.time for frame in frames)
    curve = beads.series("retention")
    for frame in frames:
        assert frame.read().field_data["saturation"][0] == curve["saturation"][int(frame.time)]


def test_throats_are_lines_between_points(beads):
    throats = beads.fields("throats")[0].read()
    assert throats.lines.shape[1] == 2 and throats.lines.max() < len(throats.points)
    assert all(len(values) == len(throats.lines) for values in throats.cell_data.values())


def test_the_network_of_a_run_has_its_pores(beads):
    assert len(beads.network().pore["volume"]) == beads.manifest["pores"]


def test_what_is_no_result_is_said(tmp_path):
    with pytest.raises(puadem.InputError, match="manifest.json"):
        puadem.Run(tmp_path)
    (tmp_path / "other.vtp").write_text("<VTKFile/>")
    with pytest.raises(puadem.InputError, match="appended raw"):
        puadem.read_polydata(tmp_path / "other.vtp")
