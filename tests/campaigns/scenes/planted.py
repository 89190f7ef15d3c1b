# SPDX-License-Identifier: BSD-3-Clause
"""Plants faults in what runs leave behind, and checks that each property finds its own: planted.py PROGRAM."""
import pathlib
import random
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parents[2] / "decks"), str(HERE.parents[2] / "decks/verification")]

import numpy as np  # noqa: E402

import evaluate as judge  # noqa: E402
from campaign import scratch_folder  # noqa: E402
from draw import draw_scene  # noqa: E402
from properties import ANGULAR_TOLERANCE_OF_NODES, MOMENTUM_TOLERANCE, momentum_scale  # noqa: E402
from variants import FRAME_TOLERANCE, VARIANTS  # noqa: E402


def add_momentum(result):
    result.columns["momentum_x"][-1] += 10 * MOMENTUM_TOLERANCE * momentum_scale(result)[0]


def add_angular_momentum(result):
    result.columns["angular_momentum_z"][-1] += 10 * ANGULAR_TOLERANCE_OF_NODES * momentum_scale(result)[1]


def add_energy_error(result):
    result.columns["energy_error"][-1] += 0.02 * np.max(result.columns["kinetic_energy"])


def give_contact_energy(result):
    result.columns["contact_energy"][-1] -= 1.02 * np.max(result.columns["kinetic_energy"])


def speed_up(result):
    for c in "xyz":
        result.frames[f"velocity_{c}"][-1] *= 2


def disturb(result):
    result.frames["velocity_x"][-1] += 10 * FRAME_TOLERANCE * np.max(np.abs(result.vector("velocity")))


def round_off(result):
    result.frames["coordinates_x"][-1, 0] = np.nextafter(result.frames["coordinates_x"][-1, 0], np.inf)


# Property that must fail, fault, whether it goes to the variant's run, variant
FAULTS = [("momentum", add_momentum, False, "threads"), ("angular momentum", add_angular_momentum, False, "threads"),
          ("energy error", add_energy_error, False, "threads"), ("contact energy", give_contact_energy, False, "threads"),
          ("kinetic energy", speed_up, False, "threads"), ("frame", disturb, True, "frame"),
          ("Galilei", disturb, True, "Galilei"), ("numbers", disturb, True, "numbers"), ("blocks", disturb, True, "blocks"),
          ("units", round_off, True, "units"), ("threads", round_off, True, "threads")]


def plain_scene(k):
    """Two free bodies that are not rigid, and meet by nodes and faces without friction."""
    while True:
        scene = draw_scene(random.Random(f"planted {k}"))
        shapes = [b["shape"] for b in scene["bodies"]]
        if (len(shapes) == 2 and not scene["plane"] and not any(b["rigid"] for b in scene["bodies"]) and scene["gap"] > 0
                and scene["contact"]["law"] == "" and scene["contact"]["enforcement"] == "" and shapes[0] == "box"):
            scene["contact"]["formulation"] = "node_face"
            return scene, k
        k += 1


def run_with(fault, in_variant):
    """The run of evaluate.py, which spoils the first or the second result."""
    real, n_runs = judge.run, [0]

    def run(*arguments):
        result = real(*arguments)
        n_runs[0] += 1
        if result.code == 0 and n_runs[0] == (2 if in_variant else 1):
            fault(result)
        return result
    return run


def check(program, folder, name, fault, in_variant, variant, scene):
    real = judge.run
    clean = judge.evaluate(program, scene, variant, "0", folder)
    judge.run = run_with(fault, in_variant)
    spoilt = judge.evaluate(program, scene, variant, "0", folder)
    judge.run = real
    is_found = name in spoilt.failed and name not in clean.failed
    print(f"{name}: {'found' if is_found else 'MISSED'} ({spoilt.failed.get(name, spoilt.ended)}), without the fault: "
          f"{clean.failed or clean.ended or 'nothing'}")
    return is_found


def check_without_contact(program, folder, shape, name):
    """Bodies that go through each other since their deck has no contact."""
    for k in range(1000):
        scene = draw_scene(random.Random(f"through {k}"))
        shapes = [b["shape"] for b in scene["bodies"]]
        if len(shapes) == 2 and shapes[0] == shape and shapes[1] == "box" and scene["speed"] > 0.02 and not scene["plane"]:
            scene["contact"]["scope"] = "none"
            scene["time"] *= 2
            verdict = judge.evaluate(program, scene, "threads", "0", folder)
            if name in verdict.failed:
                print(f"{name}: found ({verdict.failed[name]})")
                return True
    print(f"{name}: MISSED")
    return False


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    assert {variant for *_, variant in FAULTS} == set(VARIANTS)
    with scratch_folder() as folder:
        folder, k, found = pathlib.Path(folder), 0, []
        for fault in FAULTS:
            scene, k = plain_scene(k + 1)
            found.append(check(program, folder, *fault, scene))
        found.append(check_without_contact(program, folder, "box", "through"))
        found.append(check_without_contact(program, folder, "sheet", "sides"))
    sys.exit(0 if all(found) else 1)


if __name__ == "__main__":
    main()
