"""heyoka's Taylor integrator, compiled for this machine as it is built, on a double pendulum's equations written by hand.

Chains of more bodies would need their equations as expressions without an O(n) recursion. Compiling is not in the times; it takes 0.1 to
0.3 s for each tolerance (printed).
"""

import sys
import time

import heyoka
from timing import timed


def equations():
    """Two uniform rods of length and mass 1/2; angles from the horizontal and their rates."""
    inner, outer, inner_rate, outer_rate = heyoka.make_vars("inner", "outer", "inner_rate", "outer_rate")
    length = mass = 0.5
    weight, half = mass * 9.81 * length, 0.5 * mass * length**2
    own = mass * length**2 / 3.0
    whole = own + mass * length**2
    coupled, turning = half * heyoka.cos(inner - outer), half * heyoka.sin(inner - outer)
    first = -turning * outer_rate**2 - 1.5 * weight * heyoka.cos(inner)
    second = turning * inner_rate**2 - 0.5 * weight * heyoka.cos(outer)
    pivot = whole * own - coupled**2
    return [
        (inner, inner_rate),
        (outer, outer_rate),
        (inner_rate, (own * first - coupled * second) / pivot),
        (outer_rate, (whole * second - coupled * first) / pivot),
    ]


def runs(kind, bodies, end, reference):
    if (kind, bodies) != ("pins", 2):
        return
    for k in range(2, 17):
        tolerance, start = 10.0**-k if k < 16 else 2.3e-16, time.perf_counter()
        rule = heyoka.taylor_adaptive(equations(), [0.0] * 4, tol=tolerance)
        compiled = time.perf_counter() - start

        def begin():
            rule.time = 0.0
            rule.state[:] = 0.0

        seconds = timed(begin, lambda: rule.propagate_until(end))
        error = abs(rule.state[1] - reference)
        print(f"heyoka at {tolerance:.0e}: order {rule.order}, error {error:.1e}, compiled in {compiled:.2f} s", file=sys.stderr)
        yield "heyoka", "Taylor", tolerance, error, seconds
