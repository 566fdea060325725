import pathlib

import pytest

import puadem

CASES = pathlib.Path(__file__).resolve().parents[2] / "cases"


@pytest.fixture
def workplace(tmp_path, monkeypatch):
    """An empty working folder."""
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.fixture(scope="session")
def beads(tmp_path_factory):
    """The tiny drainage case, run once."""
    return puadem.Case.from_file(CASES / "drainage-beads" / "tiny.toml").run(tmp_path_factory.mktemp("beads") / "run")


@pytest.fixture
def lattice():
    """27 touching spheres of radius 1 mm on a simple cubic lattice that fills its box."""
    places = [(1e-3 + 2e-3 * i, 1e-3 + 2e-3 * j, 1e-3 + 2e-3 * k) for i in range(3) for j in range(3) for k in range(3)]
    return puadem.Packing(places, [1e-3] * 27, [6e-3] * 3)
