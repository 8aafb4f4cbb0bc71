"""Compare a detector's distances with what right and wrong sums give for the same odometry."""

import numpy

# Allowed differences: m, plus a share of the distance.
FITS = 2e-3, 1e-3  # from the sum that a mistake gives
ROUGH = 0.03, 0.02  # from a sum of speeds, which odometry samples
TOLERANCE = 0.05, 0.01  # from the true distance; a detector may leave out small steps
SCALED = 'times', 'speed', 'signed_speed', 'backwards'  # mistakes that fit with any factor
# From sums that fit less exactly: a displacement may come from speeds, and a message just before,
# or after, the end of a leg changes a sum of displacements by up to two metres.
TOLERANCES = {'displacement': TOLERANCE, 'displacements': (0.05, 0.1),
              **dict.fromkeys(SCALED[1:], ROUGH)}
FALL = 0.05  # m by which no later message may say less


def measure_detector(m, run):
    """Measure what the detector counted on each leg, and which mistakes fit."""
    m.fits = set()
    if not (run.legs and run.moved and len(run.odometry) > run.start + 1):
        return
    odometry = numpy.array([pose[:6] for pose in run.odometry[run.start:]])
    times, published = numpy.array(run.moved).T
    # Until its first message a detector has counted nothing.
    times, published = numpy.append(-numpy.inf, times), numpy.append(0.0, published)
    _, first, _ = run.legs[0]
    ends = numpy.array([first, *(end for *_, end in run.legs)])
    # A leg ends at rest, so the last message before its end has all of it, even at half a hertz.
    counted = published[_last_before(ends, times)]
    at_ends = _last_before(ends, odometry[:, 0])
    steps = _steps(odometry)
    sums = {name: numpy.append(0.0, numpy.cumsum(added))[at_ends]
            for name, added in steps.items()}
    right = sums['times']
    sums.update(_distances(odometry, at_ends, right))
    is_right = _agree(counted, right, TOLERANCE)
    m.fits = {*_fits(counted, right, sums)}
    m.largest = published.max()
    fall = numpy.diff(published).argmin()
    m.fell_from, m.fell_to = published[fall:fall + 2]
    m.only_falls = is_right and m.fell_from - m.fell_to > FALL
    m.passed = is_right and not m.only_falls
    m.largest_step = steps['times'].max()
    _note_numbers(m, [name for name, *_ in run.legs], counted, right)


def _last_before(moments, times):
    """Return the index of the last time before each moment (s)."""
    return (numpy.searchsorted(times, moments - 1e-6) - 1).clip(0)


def _steps(odometry):
    """Return what each message adds, by the name of a mistake; "times" is right, times a factor."""
    time, x, y, _, speeds, _ = odometry.T
    dt = numpy.diff(time)
    dx = numpy.diff(x)
    dy = numpy.diff(y)
    speed = speeds[1:]
    return {
        'times': numpy.hypot(dx, dy),
        'squares': dx**2 + dy**2,
        'x_only': abs(dx),
        'y_only': abs(dy),
        'signed_x': dx,
        'axes': abs(dx) + abs(dy),
        'signed_axes': dx + dy,
        'speed': abs(speed),
        'signed_speed': speed,
        'backwards': speed * dt,
        'rounded_1': _rounded_steps(x, y, 1),
        'rounded_2': _rounded_steps(x, y, 2)}


def _rounded_steps(x, y, digits):
    dx = numpy.diff(numpy.round(x, digits))
    dy = numpy.diff(numpy.round(y, digits))
    return numpy.hypot(dx, dy)


def _distances(odometry, at_ends, right):
    """Return what is published in place of the sum of steps, by the name of a mistake."""
    x, y = odometry[:, 1:3].T
    displacement = numpy.hypot(x - x[0], y - y[0])
    from_origin = numpy.hypot(x, y)
    return {
        'displacement': displacement[at_ends],
        'origin': from_origin[at_ends],
        'displacements': numpy.cumsum(displacement)[at_ends],
        'first_step': right + from_origin[0]}


def _fits(counted, right, sums):
    """Yield the mistakes that fit, as pairs of name and factor."""
    for name, values in sums.items():
        tolerance = TOLERANCES.get(name, FITS)
        factor = 1.0
        if name in SCALED:
            factor = counted @ values / (values @ values or 1.0)
        is_wrong = name in ('first_step', *SCALED) or not _agree(values, right, tolerance)
        if is_wrong and _agree(counted, factor * values, tolerance):
            yield name, float(f'{factor:.2g}')


def _agree(counted, expected, tolerance):
    metres, share = tolerance
    allowed = metres + share * abs(expected)
    return bool(numpy.all(abs(counted - expected) <= allowed))


def _note_numbers(m, legs, counted, right):
    """Set the numbers that sentences quote."""
    m.offset = counted[0]
    m.total = counted[-1]
    m.right = right[-1]
    m.share = m.right / (m.total or 1.0)
    m.counted_back = counted[2]
    m.out_and_back = right[2]
    by_leg = numpy.diff(counted, prepend=0.0)
    right_by_leg = numpy.diff(right, prepend=0.0)
    worst = int(abs(by_leg - right_by_leg).round(2).argmax())  # of equal ones the first
    m.leg = ['before the robot moved', *legs][worst]
    m.leg_counted = round(by_leg[worst], 2) + 0.0  # not -0.0
    m.leg_right = right_by_leg[worst]
