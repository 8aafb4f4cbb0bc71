"""Compares a detector with what it may have added up from the same odometry."""

import numpy

# m, and share of the distance, between what was counted and
FITS = 2e-3, 1e-3  # what fits
ROUGH = 0.03, 0.02  # what fits by speed, which odometry gives for the moment only
TOLERANCE = 0.05, 0.01  # what is right; a detector may leave out small steps


def measure_detector(m, run):
    """Note what the detector counted on each leg, and which mistakes fit."""
    m.fits = set()
    if not (run.legs and run.moved and len(run.odometry) > run.start + 1):
        return
    odometry = numpy.array([pose[:6] for pose in run.odometry[run.start:]])
    counted_at, published = numpy.array(run.moved).T
    ends = numpy.array([run.legs[0][1], *(end for *_, end in run.legs)])
    # A leg ends at rest: the last message before has all of it, also of who publishes once a second.
    counted = published[(numpy.searchsorted(counted_at, ends - 1e-6) - 1).clip(0)]
    at = (numpy.searchsorted(odometry[:, 0], ends - 1e-6) - 1).clip(0)
    sums = {name: numpy.append(0.0, numpy.cumsum(steps))[at] for name, steps in _steps(odometry.T).items()}
    right = sums.pop('right')
    m.passed = _agree(counted, right, *TOLERANCE)
    m.fits = {*_fits(m, counted, right, sums, odometry, at)}
    m.offset, m.total, m.right, m.largest = counted[0], counted[-1], right[-1], published.max()
    m.share = m.right / (m.total or 1.0)
    m.counted_back, m.out_and_back = counted[2], right[2]
    by_leg, right_by_leg = numpy.diff(counted), numpy.diff(right)
    worst = int(numpy.argmax(abs(by_leg - right_by_leg)))
    m.leg, m.leg_counted, m.leg_right = run.legs[worst][0], by_leg[worst], right_by_leg[worst]


def _fits(m, counted, right, sums, odometry, at):
    """Yield names of mistakes that fit, with a factor or None."""
    x, y = odometry[:, 1:3].T
    by_speed = {name: sums.pop(name) for name in ('speed', 'signed_speed', 'backwards')}
    sums.update(displacement=numpy.hypot(x - x[0], y - y[0])[at], origin=numpy.hypot(x, y)[at],
                first_step=right + numpy.hypot(x[0], y[0]))
    for name, values in sums.items():
        is_wrong = name == 'first_step' or not _agree(values, right, *FITS)
        if is_wrong and _agree(counted, values, *FITS):
            yield name, None
    for name, values, bound in (('times', right, FITS), *((name, values, ROUGH) for name, values in by_speed.items())):
        factor = counted @ values / (values @ values or 1.0)
        if _agree(counted, factor * values, *bound):
            yield name, round(float(factor), 2)


def _agree(counted, expected, metres, share):
    return bool(numpy.all(abs(counted - expected) <= metres + share * abs(expected)))


def _steps(odometry):
    """Return what each message may add, by the name of the mistake."""
    time, x, y, _, speed, _ = odometry
    dx, dy, speed = numpy.diff(x), numpy.diff(y), speed[1:]
    rounded = {f'rounded_{digits}': numpy.hypot(*(numpy.diff(numpy.round(axis, digits)) for axis in (x, y)))
               for digits in (1, 2)}
    return {'right': numpy.hypot(dx, dy), 'x_only': abs(dx), 'y_only': abs(dy), 'axes': abs(dx) + abs(dy),
            'signed_axes': dx + dy, 'signed_x': dx, 'squares': dx**2 + dy**2,
            'signed_speed': speed, 'speed': abs(speed), 'backwards': speed * numpy.diff(time), **rounded}
