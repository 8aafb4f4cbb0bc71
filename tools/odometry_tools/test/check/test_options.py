"""What the words of a command name."""

import sys
from pathlib import Path

import pytest
from odometry_common.parameters import StartError
from odometry_tests.scripts import ROOT
from odometry_tools.check.options import program_of


def make_package(folder, *nodes):
    """Make a package with these files in src, and return it."""
    (folder / 'src').mkdir(parents=True)
    (folder / 'package.xml').touch()
    for node in nodes:
        (folder / 'src' / node).touch()
    return folder


def test_the_folder_of_a_package_is_its_node_and_its_modules_are_for_the_node_alone(tmp_path):
    package = make_package(tmp_path / 'mine', 'turn.py', '__init__.py')
    program = program_of([str(package), '_x:=1'])
    assert program.command == [sys.executable, str(package / 'src' / 'turn.py'), '_x:=1']
    (name, paths), = program.environment
    assert (name, paths.split(':')[0]) == ('PYTHONPATH', str(package / 'src'))
    assert str(package / 'src') not in sys.path


def test_a_package_with_two_nodes_asks_for_one(tmp_path):
    with pytest.raises(StartError, match='2 files could be the node of mine: say PACKAGE NODE'):
        program_of([str(make_package(tmp_path / 'mine', 'a.py', 'b.py'))])


def test_a_package_and_a_node_are_those_of_rosrun_wherever_one_stands(monkeypatch):
    monkeypatch.chdir(ROOT)  # where a folder has the name of the package
    command = program_of(['rotate_robot', 'rotate.py']).command
    assert (len(command), Path(command[0]).name) == (1, 'rotate.py')
