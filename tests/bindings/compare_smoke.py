#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Compares what the good calls return in another language with what they return in C.

    compare_smoke.py [--partly] REFERENCE PROGRAM...

REFERENCE is the program smoke_reference, PROGRAM the command of another one. Both print lines: the call, a parameter of the
C function, and the elements that it received, as smoke_reference.cpp describes them. Lines of one parameter belong
together, because a result may have its elements in several places. A language need not return every output of C (lengths
of arrays, for instance), with --partly not even all others, and it may return outputs that the call in C leaves out; what
both return has the same bits.
"""

import subprocess
import sys
from collections import defaultdict

WRAPPERS_KNOW = {"count", "entries", "length"}  # in the lengths of what they return


def printed(command):
    """{call: {parameter: elements}}, and the calls that are by hand."""
    done = subprocess.run(command, stdout=subprocess.PIPE, text=True, encoding="utf-8", errors="surrogateescape")
    if done.returncode != 0:
        print(done.stdout[-1000:])  # where it stopped, or that a language is missing
        sys.exit(done.returncode)
    calls, by_hand = defaultdict(lambda: defaultdict(list)), []
    for line in done.stdout.splitlines():
        call, parameter, *elements = line.split("|", 2)
        if parameter == "by hand":
            by_hand.append(call)
        elif parameter == "done":
            calls[call].update()
        else:
            calls[call][parameter] += elements[0].lower().split()
    return calls, by_hand


def differences(reference, found, by_hand, partly):
    for call, outputs in reference.items():
        if call in by_hand:
            continue
        if call not in found:
            yield f"{call} was not called"
        for parameter, elements in outputs.items():
            own = found[call].get(parameter)
            if own is None:
                if parameter not in WRAPPERS_KNOW and not partly:
                    yield f"{call}: {parameter} was not returned"
            elif own != elements:
                place = next((i for i, pair in enumerate(zip(own, elements)) if pair[0] != pair[1]), min(len(own), len(elements)))
                yield f"{call}: {parameter}[{place}] of {len(own)} elements differs from C, which has {len(elements)}"
    for call in found.keys() - reference.keys():
        yield f"{call} is no call of C"


def main(arguments):
    partly = arguments[:1] == ["--partly"]
    arguments = arguments[partly:]
    if len(arguments) < 2:
        print(__doc__, file=sys.stderr)
        return 2
    reference, _ = printed(arguments[:1])
    found, by_hand = printed(arguments[1:])
    problems = list(differences(reference, found, by_hand, partly))
    print("\n".join(problems))
    compared = sum(len(outputs.keys() & found[call].keys()) for call, outputs in reference.items() if call in found)
    print(f"{len(found)} calls, {compared} outputs compared, {len(by_hand)} calls by hand, {len(problems)} problems")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
