"""Regenerate docs/reference.md and launch/sim.launch: ./ws python3 test/tools/reference.py.

What stands under a heading that names a node, a launch file, the demo, the sweep or the check comes from there;
the arguments of sim.launch that are parameters come from the simulator's table.
"""

import inspect
import re
from xml.etree import ElementTree
from xml.sax.saxutils import quoteattr

from odometry_common.parameters import Parameters
from odometry_tests.scripts import ROOT, SCRIPTS, load_script
from odometry_tools.check.options import make_parser as make_check_parser
from odometry_tools.runs import options as demo_options
from odometry_tools.sweep.options import make_parser as make_sweep_parser
from sim_turtlebot.settings import PARAMETERS

PAGE = ROOT / 'docs/reference.md'
SIM_LAUNCH = ROOT / 'launch/sim.launch'
GENERATED = re.compile(r'^## (\S+\.py|\S+\.launch|\./ws demo|\./ws sweep|\./ws check)\n.*?(?=^## |\Z)',
                       re.DOTALL | re.MULTILINE)
# Those of sim.launch that the simulator's table gives.
ARGUMENTS = re.compile(r'  <arg name="gui".*?(?=  <arg name="use_sim_time")', re.DOTALL)
PASSED = re.compile(r'    <param name="gui".*?(?=  </node>)', re.DOTALL)
KINDS = {'Subscribes': 'sub', 'Publishes': 'pub', 'Calls': 'calls', 'Services': 'srv'}
SECTION = re.compile(rf'^({"|".join(KINDS)}):\n((?: +.*\n?)+)', re.MULTILINE)
ENTRY = re.compile(r'^    (?=\S)', re.MULTILINE)
PARTS = re.compile(r'(?P<names>[^(]+) \((?P<type>.+?)\): (?P<meaning>.*)')
BASE_LAUNCH = 'sim.launch'
# The node of each launch file whose parameters are its arguments.
LAUNCHED_NODE = {'sim.launch': 'sim_turtlebot_node.py',
                 'move_two_meters.launch': 'test_movement.py',
                 'rotate.launch': 'rotate.py'}
PARSERS = {'./ws demo': demo_options.make_parser, './ws sweep': make_sweep_parser,
           './ws check': make_check_parser}


def main():
    SIM_LAUNCH.write_text(updated_launch(SIM_LAUNCH.read_text()))
    PAGE.write_text(updated(PAGE.read_text()))


def updated(page):
    """Return the page with every part that comes from elsewhere as it is there."""
    return GENERATED.sub(lambda found: f'## {found[1]}\n\n{_part(found[1])}\n\n', page).rstrip() + '\n'


def updated_launch(text):
    """Return the text of sim.launch with an argument for each parameter of the simulator."""
    default = defaults('sim_turtlebot_node.py')
    arguments, passed = '', ''
    for row in PARAMETERS.rows:
        name = row.name[1:]
        unit = f' ({row.unit})' if row.unit else ''
        # roslaunch takes an empty value for none, unless it is a string.
        kind = ' type="str"' if row.type == 'str' else ''
        arguments += f'  <arg name="{name}" default="{default[name]}" doc={quoteattr(row.meaning + unit)}/>\n'
        passed += f'    <param name="{name}" value="$(arg {name})"{kind}/>\n'
    return PASSED.sub(lambda _: passed, ARGUMENTS.sub(lambda _: arguments, text))


def _part(heading):
    if heading.endswith('.launch'):
        return _launch_part(heading)
    if heading in PARSERS:
        return _options_part(PARSERS[heading]())
    return _node_part(heading)


def _script(name):
    path, = (path for path in SCRIPTS if path.name == name)
    return load_script(path)


def _topic_rows(documentation):
    """Yield a row for each topic and service in a node's docstring, or for several that are alike."""
    for title, block in SECTION.findall(documentation):
        for entry in filter(None, ENTRY.split(block)):
            parts = PARTS.fullmatch(' '.join(entry.split()))
            assert parts, f'this is not "name (type): meaning": {entry}'
            yield KINDS[title], _code(parts['names']), parts['type'], parts['meaning']


def _node_part(heading):
    script = _script(heading)
    table = getattr(script, 'PARAMETERS', Parameters())
    documentation = f'{inspect.getdoc(script)}\n'.replace(table.help, '')
    prose = re.split(r'\n\n+', SECTION.sub('', documentation).strip())
    parameters = [(_code(row.name), row.type, _code(row.default_text), row.range, row.meaning)
                  for row in table.rows]
    options = _options_part(script.make_parser()) if hasattr(script, 'make_parser') else ''
    return '\n\n'.join(filter(None, [
        *prose, options, _table('direction | name | type | meaning', [*_topic_rows(documentation)]),
        _table('parameter | type | default | range | meaning', parameters)]))


def _launch_part(name):
    """Name the arguments that are described elsewhere, and describe the others."""
    own, node = _arguments(name), LAUNCHED_NODE.get(name)
    parameters = defaults(node) if node else {}
    known = {} if name == BASE_LAUNCH else _arguments(BASE_LAUNCH)
    passed = _code(', '.join(argument for argument, (default, _) in own.items() if parameters.get(argument) == default))
    shared = _code(', '.join(argument for argument in own if argument in known))
    table = _table('argument | default | meaning', [
        (_code(argument), _code(default), meaning) for argument, (default, meaning) in own.items()
        if default is not None and argument not in known and parameters.get(argument) != default])
    if name == BASE_LAUNCH:
        return f'Every parameter of {node}, and:\n\n{table}'
    return f'{passed} of {node}, and {shared} of {BASE_LAUNCH}.' if node else f'{table}\n\nAnd {shared} of {BASE_LAUNCH}.'


def defaults(node):
    """Return the default of each parameter of a node, as a launch file has it."""
    texts = {row.name[1:]: str(row.default) for row in _script(node).PARAMETERS.rows}
    return {name: {'False': 'false', 'True': 'true'}.get(text, text) for name, text in texts.items()}


def _arguments(name):
    """Return default and meaning of each argument of a launch file."""
    root = ElementTree.parse(ROOT / 'launch' / name)
    return {arg.get('name'): (arg.get('default'), arg.get('doc')) for arg in root.iterfind('arg')}


def _options_part(parser):
    return _table('option | meaning', [
        (_code(_usage(action)), action.help % vars(action)) for action in parser._actions
        if action.dest != 'help'])


def _usage(action):
    value = '|'.join(action.choices) if action.choices else action.metavar or ''
    value = ' '.join(value) if isinstance(value, tuple) else value
    return ' '.join(filter(None, [', '.join(action.option_strings), value]))


def _code(names):
    return ', '.join(f'`{name}`' for name in names.split(', ') if name)


def _table(heading, rows):
    if not rows:
        return ''
    lines = [' | '.join(cell.replace('|', '\\|') for cell in row) for row in rows]
    rule = ' | '.join('---' for _ in heading.split('|'))
    return '\n'.join([heading, rule, *lines])


if __name__ == '__main__':
    main()
