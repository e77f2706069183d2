"""What every Python peer does alike: one job, timed or printed once.

PEER METHOD DIGITS           compute once and print the six unknowns
PEER METHOD DIGITS --time    warm up, then time the computation alone; one line of JSON
"""

import sys
from time import process_time

from triple import UNKNOWNS

SAMPLE = 0.05  # seconds of CPU time in which calls are counted together
SAMPLES = 7
BUDGET = 60.0  # seconds after which no further sample is begun
COLD = 20.0  # a first call that takes longer is the measurement


def cpu(job, calls=1):
    """CPU time of some calls, and what the last gives."""
    start = process_time()
    for _ in range(calls):
        result = job()
    return process_time() - start, result


def measure(job):
    """The median CPU time of a call, whether there was a warm-up, and what the job gives."""
    first, result = cpu(job)
    if first > COLD:
        return first, False, result
    calls = 1
    while cpu(job, calls)[0] < SAMPLE:
        calls *= 2
    samples = []
    while len(samples) < SAMPLES and sum(samples) < BUDGET:
        samples.append(cpu(job, calls)[0])
    return sorted(samples)[len(samples) // 2] / calls, True, result


def main(methods):
    """`methods`: name -> (digits -> (job, the job's result -> six decimals, or None))."""
    sys.set_int_max_str_digits(0)
    method, digits = sys.argv[1], int(sys.argv[2])
    job, decimals = methods[method](digits)
    if "--time" in sys.argv[3:]:
        import json  # not part of a peer's start-up

        seconds, warm, result = measure(job)
        print(json.dumps({"seconds": seconds, "warm": warm, "values": decimals(result)}))
    else:
        for name, value in zip(UNKNOWNS, decimals(job())):
            print(name, value)
