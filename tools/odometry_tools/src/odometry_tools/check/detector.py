"""Compares a detector with what it may have added up from the same odometry."""

import numpy

# m, and share of the distance, between what was counted and
FITS = 2e-3, 1e-3  # what fits
ROUGH = 0.03, 0.02  # what fits by speed, which odometry gives for the moment only
BEFORE = 0.4  # s before the end of a leg, when the robot stands, and who answers has answered
TOLERANCE = 0.05, 0.01  # what is right; a detector may leave out small steps


def measure_detector(m, run):
    """Note what the detector counted on each leg, and which mistake fits."""
    if not (run.legs and run.moved):
        return
    time, x, y, _, speed, _ = numpy.array(run.odometry).T
    heard, published = numpy.array(run.moved).T
    ends = [run.legs[0][1], *(end for *_, end in run.legs)]
    at, heard_at = (numpy.maximum(0, numpy.searchsorted(times, numpy.subtract(ends, BEFORE)) - 1)
                    for times in (time, heard))
    sums = {name: numpy.append(0.0, numpy.cumsum(steps))[at]
            for name, steps in _steps(x, y, speed[1:], numpy.diff(time)).items()}
    right, counted = sums.pop('right'), published[heard_at]
    scaled = {'total': (right, FITS), 'signed_speed': (sums.pop('signed_speed'), ROUGH),
              'speed': (sums.pop('speed'), ROUGH)}
    sums.update(displacement=numpy.hypot(x - x[0], y - y[0])[at], origin=numpy.hypot(x, y)[at],
                first_step=right + numpy.hypot(x[0], y[0]))
    m.passed = _agree(counted, right, *TOLERANCE)
    m.fits = next((name for name, values in sums.items() if _agree(counted, values, *FITS)), None)
    for name, (values, bound) in () if m.fits else scaled.items():
        m.factor = counted @ values / (values @ values or 1.0)
        if _agree(counted, m.factor * values, *bound):
            m.fits = f'times_{name}'
            break
    m.offset, m.total, m.right, m.largest = counted[0], counted[-1], right[-1], published.max()
    by_leg, right_by_leg = numpy.diff(counted), numpy.diff(right)
    worst = int(numpy.argmax(abs(by_leg - right_by_leg)))
    m.leg, m.leg_counted, m.leg_right = run.legs[worst][0], by_leg[worst], right_by_leg[worst]
    m.back, m.right_back, m.counted_back, m.out_and_back = by_leg[1], right_by_leg[1], counted[2], right[2]
    m.true_dt = float(numpy.median(numpy.diff(time)))
    m.dt = getattr(m, 'factor', 0.0) * m.true_dt


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
