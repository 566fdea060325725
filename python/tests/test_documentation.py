"""The examples of docs/python.md and of README.md run as printed."""

import pathlib
import re
import textwrap

import puadem

HOME = pathlib.Path(__file__).resolve().parents[2]
PAGE = HOME / "docs" / "python.md"


def test_the_examples_run(workplace, capsys):
    blocks = re.findall(r"^```python\n(.*?)^```$", PAGE.read_text(), re.MULTILINE | re.DOTALL)
    assert len(blocks) >= 4
    names = {}
    for block in blocks:
        exec(compile(block, str(PAGE), "exec"), names)
    assert "nan" not in capsys.readouterr().out


def test_the_example_of_the_readme_runs(workplace, capsys):
    example = re.search(r"^## Python\n\n((?:    .*\n)+)", (HOME / "README.md").read_text(), re.MULTILINE)
    puadem.Case.from_file(HOME / "cases" / "drainage-beads" / "tiny.toml").run()
    exec(compile(textwrap.dedent(example[1]), "README.md", "exec"), {})
    assert "1300." in capsys.readouterr().out
