"""Compares a detector with what it may have added up from the same odometry."""

import numpy

FITS = 2e-3, 1e-3  # m, share of the distance
TOLERANCE = 0.05, 0.01  # the same, of a detector that is right; it may leave out small steps


def measure_detector(m, run):
    """Note what the detector counted on each leg, and which mistake fits."""
    m.passed, m.fits, m.factor, m.at = False, None, 0.0, ''
    if not (run.legs and run.moved):
        return
    time, x, y, _, speed, _ = numpy.array(run.odometry).T
    ends = [run.legs[0][1], *(end for *_, end in run.legs)]
    moments = [max(0, numpy.searchsorted(time, end + 1e-6) - 1) for end in ends]
    heard, published = numpy.array(run.moved).T
    m.counted = published[[max(0, numpy.searchsorted(heard, end + 1e-6) - 1) for end in ends]]
    sums = {name: numpy.concatenate([[0.0], numpy.cumsum(steps)])[moments] for name, steps in _steps(
        x, y, speed[1:], numpy.diff(time)).items()}
    sums['displacement'] = numpy.hypot(x - x[0], y - y[0])[moments]
    sums['origin'] = numpy.hypot(x, y)[moments]
    m.expected = sums.pop('right')
    sums['first_step'] = m.expected + numpy.hypot(x[0], y[0])
    m.offset, m.total, m.right = m.counted[0], m.counted[-1], m.expected[-1]
    m.passed = _agree(m.counted, m.expected, *TOLERANCE)
    m.fits = next((name for name, values in sums.items() if _agree(m.counted, values, *FITS)), None)
    for name in () if m.fits else ('signed_speed', 'speed', 'total'):
        values = {'total': m.expected}.get(name, sums.get(name))
        m.factor = m.counted @ values / (values @ values or 1.0)
        if m.factor and _agree(m.counted, m.factor * values, 0.01, 0.01):
            m.fits = f'times_{name}'
            break
    worst = int(numpy.argmax(abs(numpy.diff(m.counted) - numpy.diff(m.expected)))) if not m.passed else 0
    m.leg = run.legs[worst][0]
    m.leg_counted, m.leg_right = numpy.diff(m.counted)[worst], numpy.diff(m.expected)[worst]
    m.back, m.right_back = numpy.diff(m.counted)[1], numpy.diff(m.expected)[1]
    m.counted_back, m.out_and_back = m.counted[2], m.expected[2]
    m.true_dt = float(numpy.median(numpy.diff(time)))
    m.dt = m.factor * m.true_dt
    m.largest = published.max()


def _agree(counted, expected, metres, share):
    return bool(numpy.all(abs(counted - expected) <= metres + share * abs(expected)))


def _steps(x, y, speed, duration):
    """Return what each message may add, by the name of the mistake."""
    dx, dy = numpy.diff(x), numpy.diff(y)
    rounded = {f'rounded_{digits}': numpy.hypot(*(numpy.diff(numpy.round(axis, digits)) for axis in (x, y)))
               for digits in (1, 2)}
    return {'right': numpy.hypot(dx, dy), 'x_only': abs(dx), 'y_only': abs(dy), 'axes': abs(dx) + abs(dy),
            'signed_axes': dx + dy, 'signed_x': dx, 'squares': dx**2 + dy**2,
            'signed_speed': speed * duration, 'speed': abs(speed) * duration, **rounded}
