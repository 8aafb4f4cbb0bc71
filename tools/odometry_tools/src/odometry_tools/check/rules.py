"""The rules: what shows in a run that is not right. The first that holds is the verdict.

Their sentences, with the measures in braces, are in sentences.yaml.
"""


def _starts(text, *words):
    return (text or '').startswith(words)


# Functions of the namespace of odometry_tools.check.measures.measure(), by name.
START = {
    'keyboard': lambda m: _starts(m.error, 'EOFError'),
    'syntax': lambda m: not m.run.nodes and _starts(m.error, 'SyntaxError', 'IndentationError', 'TabError'),
    'unregistered': lambda m: not m.run.nodes and not m.ended,
    'crash': lambda m: m.crashed,
    'callback': lambda m: m.bad_callback,
    'type': lambda m: m.type not in (None, m.wanted),
    'elsewhere': lambda m: m.silent and m.elsewhere,
    'unheard': lambda m: m.silent and m.unheard,
    'queue_size': lambda m: m.silent and m.refused,
    'lost_command': lambda m: m.silent and m.ended,
    'silent': lambda m: m.silent}
DRIVE = {
    'wrong_field': lambda m: m.useless and m.stays,
    'never_began': lambda m: not m.moves,
    'one_command': lambda m: m.ceased and m.run.interrupted is None and m.sent <= 5,
    'interrupt_ignored': lambda m: m.run.interrupted is not None and not m.run.ends,
    'interrupt': lambda m: m.run.interrupted is not None}
DISTANCE = {
    'no_zero': lambda m: m.ceased and 1.9 < m.gone < 2.2,
    'ceased': lambda m: m.ceased,
    'position': lambda m: m.name == 'moved_start' and m.gone < 0.3,
    'one_axis': lambda m: m.name == 'moved_start' and m.stop and min(
        abs(m.moved_x - 2), abs(m.moved_y - 2)) < 0.06,
    'sum_of_axes': lambda m: m.name == 'moved_start' and m.stop and abs(m.moved_x + m.moved_y - 2) < 0.06,
    'elapsed_time': lambda m: m.stop and m.early and abs(m.commanded - 2) < 0.12 and m.gone < 1.8,
    'early': lambda m: m.stop and m.early,
    'too_slow': lambda m: m.early,
    'passed_by': lambda m: not m.stop and (m.name in ('plain', 'slow_base') or 'passed_by' in m.seen),
    'window': lambda m: not m.stop and m.name == 'odom_5hz',
    'goal_point': lambda m: not m.stop,
    'late': lambda m: True}
HEADING = {
    'ceased': lambda m: m.ceased,
    'window': lambda m: m.name == 'odom_5hz' and m.turned > m.shortest + 180 and m.is_constant and (
        m.flips < 5 and 'equality' not in m.seen),
    'degrees': lambda m: m.spins and m.typical > 3.1,
    'equality': lambda m: m.spins and m.is_constant,
    'quaternion': lambda m: m.spins,
    'sign': lambda m: m.first * m.error_at_start < 0 and (
        'sign' in m.seen or m.name == 'plain' and not (m.settled and m.off < 25)),
    'chatter': lambda m: m.rings and m.is_constant and m.off < 25,
    'gain_high': lambda m: m.rings or m.turned - abs(m.net) > 60,
    'wrap': lambda m: m.turned > m.shortest + 90 and m.off < 25,
    'jump': lambda m: m.name == 'moved_start' and m.settled and abs(m.yaw) > 174,
    'turns_by': lambda m: m.name == 'moved_start' and m.settled and m.off > 25 and abs(m.net - 90) < 8,
    'gain_low': lambda m: not m.settled or m.moves_at_end,
    'short': lambda m: m.off < 25,
    'other_goal': lambda m: True}
DETECTOR = {
    'displacement': lambda m: m.fits == 'displacement',
    'from_origin': lambda m: m.fits in ('origin', 'first_step'),
    'one_axis': lambda m: m.fits in ('x_only', 'y_only', 'signed_x'),
    'sum_of_axes': lambda m: m.fits in ('axes', 'signed_axes'),
    'rounded': lambda m: _starts(m.fits, 'rounded'),
    'signed_speed': lambda m: m.fits == 'times_signed_speed' and abs(m.factor - 1) < 0.05,
    'last_step': lambda m: m.largest < 0.3,
    'squares': lambda m: m.fits == 'squares',
    'fixed_dt': lambda m: m.fits in ('times_signed_speed', 'times_speed'),
    'times': lambda m: m.fits == 'times_total',
    'miscounted': lambda m: True}
# These hold or not, whatever the verdict.
NOTES = {
    'no_sleep': lambda m: m.run.unawaited and m.sent / m.duration > 200,
    'wall_time': lambda m: m.run.unawaited and m.sent / m.duration <= 200,
    'hidden_error': lambda m: m.bad_callback and m.passed,
    'forked': lambda m: m.run.forked,
    'ctrl_c': lambda m: not m.run.ends and m.run.interrupted is None}
DRIVE_NOTES = {
    'mux': lambda m: m.mux,
    'too_fast': lambda m: m.top_speed > 0.71,
    'stops_early': lambda m: m.short_by > 0.01 and m.passed}
