"""Time of a run."""

import statistics
import time

BUDGET = 0.03  # (s) for which a run is repeated


def timed(begin, run):
    """The median time of a run (s), each begun anew."""
    seconds, start = [], time.perf_counter()
    while len(seconds) < 3 or time.perf_counter() - start < BUDGET:
        begin()
        now = time.perf_counter()
        run()
        seconds.append(time.perf_counter() - now)
    return statistics.median(seconds)
