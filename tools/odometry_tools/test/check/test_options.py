"""What the words of a command name."""

import os
import re
import sys

import pytest
from odometry_common.parameters import StartError
from odometry_tests.scripts import ROOT
from odometry_tools.check.options import program_of


def test_the_folder_of_a_package_is_its_node_and_its_modules_are_for_the_node_alone(tmp_path):
    (tmp_path / 'src').mkdir()
    for name in 'package.xml', 'src/turn', 'src/__init__.py':
        (tmp_path / name).write_text('#!/usr/bin/env python3')
    program = program_of([str(tmp_path), '_x:=1'])
    assert program.command == [sys.executable, str(tmp_path / 'src/turn'), '_x:=1']
    (name, paths), = program.environment
    assert (name, paths.split(':')[0]) == ('PYTHONPATH', str(tmp_path / 'src'))
    assert str(tmp_path / 'src') not in sys.path


def test_a_package_with_several_nodes_asks_for_one():
    with pytest.raises(StartError, match='3 Python files could be the node of example: say PACKAGE NODE, with'):
        program_of([str(ROOT / 'docs/example')])


@pytest.mark.parametrize('line, complaint', [
    ('import rospy\n', 'must be #!/usr/bin/env python3'),
    ('#!/usr/bin/env python3\r\n', 'ends as on Windows'),
    ('#!/usr/bin/python2.5\n', 'names /usr/bin/python2.5, which is not on this machine')])
def test_a_script_that_the_system_cannot_start_says_why(tmp_path, line, complaint):
    path = tmp_path / 'node.py'
    path.write_bytes(line.encode())
    path.chmod(0o755)
    with pytest.raises(StartError, match=re.escape(f'the first line of node.py {complaint}')):
        program_of([str(path)])


def test_code_in_a_launch_file_does_not_run_in_this_process(tmp_path):
    """As roslaunch runs it when it reads a file."""
    path = tmp_path / 'evil.launch'
    path.write_text('<launch><rosparam>x: !radians "len(__import__(\'os\').environ.setdefault(\'EVIL\', \'1\'))"'
                    '</rosparam></launch>')
    words = [str(path)]
    assert program_of(words).command == ['roslaunch', *words]
    assert 'EVIL' not in os.environ
    with pytest.raises(StartError, match='evil.launch has no argument _target; it has none'):
        program_of([*words, '_target:=90'])
