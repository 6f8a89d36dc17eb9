"""The stroke of the mould, and what follows it: negative strip, level, shell."""

import numpy as np


def negative_strip_time(stroke: float, frequency: float, casting_speed: float) -> float:
    """Time of each cycle [s] in which the mould sinks faster than the strand.

    60/(pi f) arccos(1000 v/(pi f s)) with f in cycles/min, s in mm and v in m/min, here in SI units: 1/(pi f)
    arccos(v/(pi f s)); 0 where the mould is never the faster one.

    Args:
        stroke: distance between the turning points [m].
        frequency: [Hz].
        casting_speed: [m/s].
    """
    fastest = np.pi * frequency * stroke
    return float(np.arccos(casting_speed / fastest) / (np.pi * frequency)) if fastest > casting_speed else 0.0


def overtaking_time(time: np.ndarray, mould: np.ndarray, strand: np.ndarray, frequency: float) -> float:
    """Time of each cycle [s], on average, in which the mould moves down faster than the strand.

    Args:
        time: (k,) evenly spaced [s].
        mould, strand: (k,) velocities along y [m/s], taken as linear between the times.
        frequency: of the mould [Hz].
    """
    lead = strand - mould  # positive where the mould sinks faster
    a, b = lead[:-1], lead[1:]
    with np.errstate(divide="ignore", invalid="ignore"):
        share = np.where(a * b >= 0.0, (a + b > 0.0), np.maximum(a, b) / (np.abs(a) + np.abs(b)))
    return float(np.sum(share * np.diff(time)) / (time[-1] - time[0]) / frequency)


def response(time: np.ndarray, values: np.ndarray, frequency: float) -> tuple[float, float]:
    """Amplitude and phase [rad] of the part of ``values`` that goes as sin(2 pi f t + phase); a trend is taken out.

    Args:
        time: (k,) [s], over whole cycles.
        values: (k,).
        frequency: [Hz].
    """
    angle = 2.0 * np.pi * frequency * time
    terms = np.column_stack([np.sin(angle), np.cos(angle), np.ones_like(time), time])
    sine, cosine, *_ = np.linalg.lstsq(terms, values, rcond=None)[0]
    return float(np.hypot(sine, cosine)), float(np.arctan2(cosine, sine))
