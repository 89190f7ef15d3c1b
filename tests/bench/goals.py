#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""How far the program is from its goals of speed and from what the machine gives, all measured in one run.

    goals.py BUILD [--rounds 5] [--count] [--without PART...]

BUILD is a folder that was built with CONTACTSIM_BENCH=ON, build/bench. Absolute goals are those of one core of an AMD EPYC
(Zen 4) that does 58.6 GFLOP/s in fused multiply-adds and 29 GB/s in STREAM's triad; they are scaled by the fused rate measured
here. How near kernels come to the least time that their bytes, operations, divisions and stores allow stands at the end, by the
operations in operations.txt; `--count` counts those anew first, which takes minutes where stopping after every instruction is
slow, and it has to follow changes of a kernel. Parts that can be left out:
impact, search, skin, heap, program, large.
"""
import argparse
import multiprocessing
import os
import resource
import subprocess
import sys
import tempfile
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parents[1] / "decks")]
sys.dont_write_bytecode = True
import heap  # noqa: E402
import kernel_lines  # noqa: E402
import skin_vs_vtk  # noqa: E402
from mesh_maker import MeshMaker  # noqa: E402

FUSED_OF_GOALS = 58.6e9
LIMITS = ["memory", "flops", "divisions", "loads", "stores"]
OPERATIONS = HERE / "operations.txt"
OPERATIONS_HEAD = "# What one thread executes per element, node or face in a step: goals.py --count, operation_count.hpp.\n"
PARTS = ["impact", "search", "skin", "heap", "program", "large"]
# What is told, kernel, goal on the machine above: million items a second, or nanoseconds an item.
RATES = [("HEX8 elastic, whole step", "whole_step", 14), ("HEX8 elastic-plastic", "hex8_plastic", 13),
         ("HEX8 selective deviatoric", "hex8_selective", 6), ("HEX8 Johnson-Cook", "hex8_johnson_cook", 8),
         ("TET4 elastic", "tet4_elastic", 45), ("shells, elastic-plastic, 5 layers", "shells_plastic_5", 4)]
TIMES = [("spheres apart, FACE_FACE", "spheres_apart", 80), ("spheres apart, NODE_FACE", "spheres_apart_node_face", 80),
         ("spheres touch, FACE_FACE, balance", "spheres_touch", 450),
         ("spheres touch, NODE_FACE, balance", "spheres_touch_node_face", 450),
         ("spheres touch, FACE_FACE, penalty", "spheres_touch_penalty", 450),
         ("spheres touch, NODE_FACE, penalty", "spheres_touch_node_face_penalty", 450)]
HEAPS = [("heap of cubes, FACE_FACE", "cubes-2000", 700), ("heap of cubes, NODE_FACE", "cubes-2000-node", 800)]
CUBE = "begin sierra cube\n" + heap.STEEL + """ begin finite element model cube
  database name = cube.g
  begin parameters for block cube
   material = steel
   model = elastic
  end
 end
 begin presto procedure p
  begin time control
   begin time stepping block all
    start time = 0
    begin parameters for presto region r
     step interval = 1000
    end
   end
   termination time = 1
  end
  begin presto region r
   use finite element model cube
   begin solution termination
    terminate global step >= 100
   end
  end
 end
end
"""


CONTACT_OF_SKIN = """   begin contact definition skin
    skin all blocks = on
    begin interaction defaults
     general contact = on
     self contact = on
    end
   end
"""


class Table:
    """Goals beside what was reached; a goal that the machine scales is given as it is here."""

    def __init__(self):
        self.missed = 0

    def head(self, title):
        print(f"\n{title:44} {'goal':>10} {'reached':>10} {'reached/goal':>13}")

    def row(self, name, goal, reached, unit, more_is_better=True):
        share = reached / goal if more_is_better else goal / reached
        self.missed += share < 1
        print(f"{name:44} {goal:10.4g} {reached:10.4g} {100 * share:11.0f} %  {unit}", flush=True)


def tell_limits(limits):
    giga = {name: number / 1e9 for name, number in limits.items()}
    print("What the machine gives at best        1 thread   2 threads")
    print(f"STREAM triad                    {giga['triad']:10.1f}  {giga['triad_2']:10.1f}  GB/s")
    print(f"reading alone                   {giga['read']:10.1f}  {giga['read_2']:10.1f}  GB/s")
    print(f"fused multiply-adds             {giga['fused']:10.1f}  {giga['fused_2']:10.1f}  GFLOP/s")
    print(f"multiply-adds apart             {giga['unfused']:10.1f}  {giga['unfused_2']:10.1f}  GFLOP/s")
    print(f"divisions                       {giga['division']:10.2f}              G/s")
    print(f"stores to the first cache       {giga['store']:10.1f}              GB/s")
    print(f"loads from the first cache      {giga['load']:10.1f}              GB/s")
    print(f"clock                           {giga['clock']:10.2f}              GHz")


def tell_kernels(found, scale, table):
    table.head("Elements")
    for name, kernel, goal in RATES:
        table.row(name, goal * scale, 1e-6 / found[kernel]["seconds"], "million a second")
    whole = found["whole_step"]
    table.row("two threads over one, whole step", 1.9, whole["wall"] / whole["wall_2"], "times")
    table.head("Contact and search")
    for name, kernel, goal in TIMES:
        table.row(name, goal / scale, 1e9 * found[kernel]["seconds"], "ns a node", False)


def count_operations(program):
    """Writes what a step of each kernel executes per item."""
    found = kernel_lines.run(program, "--rounds", 0, "--operations")
    del found["limits"]
    kinds = ["flops", "divisions", "instructions", "loaded", "stored"]
    OPERATIONS.write_text(OPERATIONS_HEAD + "".join(
        " ".join([name] + [f"{kind} {kernel[kind]:.4g}" for kind in kinds]) + "\n"
        for name, kernel in found.items() if "flops" in kernel))


def with_operations(found):
    counted = kernel_lines.read_lines("".join(line for line in OPERATIONS.open() if not line.startswith("#")))
    return {name: kernel | counted.get(name, [{}])[-1] for name, kernel in found.items()}


def bounds(kernel, limits):
    """The least seconds an item by each of the machine's limits."""
    rates = {"memory": ("bytes", "triad"), "flops": ("flops", "unfused"), "divisions": ("divisions", "division"),
             "loads": ("loaded", "load"), "stores": ("stored", "store")}
    return {name: kernel[amount] / limits[rate] for name, (amount, rate) in rates.items() if amount in kernel}


def tell_rooflines(found, limits):
    print(f"\n{'Per item, one thread':24} {'ns':>7} {'bytes':>7} {'flops':>7} {'divs':>6} {'loaded':>7} {'stored':>7} {'instr.':>7} {'per clock':>9}"
          f" {'GFLOP/s':>8}  {'memory':>7} {'flops':>7} {'divs':>7} {'loads':>7} {'stores':>7}  share of the bound")
    for name, kernel in found.items():
        least = bounds(kernel, limits)
        seconds, bound = kernel["seconds"], max(least, key=least.get)
        get = lambda key: kernel.get(key, float("nan"))
        print(f"{name:24} {1e9 * seconds:7.1f} {kernel['bytes']:7.0f} {get('flops'):7.0f} {get('divisions'):6.1f} "
              f"{get('loaded'):7.0f} {get('stored'):7.0f} {get('instructions'):7.0f} {get('instructions') / seconds / limits['clock']:9.2f} "
              f"{get('flops') / seconds / 1e9:8.1f}  "
              + " ".join(f"{1e9 * least.get(limit, float('nan')):7.1f}" for limit in LIMITS)
              + f"  {100 * least[bound] / seconds:3.0f} % of {bound}")


def tell_search(lines, table):
    for line in lines:
        best = min(line["embree_refit"], line["embree_rebuild"])
        name = f"search, {line['faces']:.0f} faces, over Embree {best:.0f} ns"
        table.row(name, best / 2, line["contactsim"], "ns a face", False)
        if line["agree"] != 1:
            sys.exit("contactsim and Embree do not find the same pairs")
    for line in lines:
        print(f"  {line['faces']:.0f} faces, {line['pairs']:.0f} pairs of both; ns a face, refit + find: "
              + ", ".join(f"{name} {line[name + '_refit']:.0f} + {line[name + '_find']:.0f}"
                          for name in ("contactsim", "embree_refit", "embree_rebuild")))


def tell_skin(program, rounds, table):
    found = skin_vs_vtk.measure(program, 100, rounds)
    if found is None:
        print("skin: python3-vtk9 is not installed")
        return
    own, faces = found["contactsim"][:2]
    for name, (seconds, n, _) in found.items():
        if name != "contactsim":
            table.row(f"skin of 100^3, {name} over ours", 5, seconds / own, f"times; {n} and {faces} faces")


def computed():
    """Seconds that programs started from here have computed."""
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def run_heap(program, folder):
    """Nanoseconds of contact per face and step; of the wall's time as much as was computed in, on a busy machine."""
    start, before = time.perf_counter(), computed()
    wall = heap.run(str(program), folder, 1)[0]
    return wall * min(1.0, (computed() - before) / (time.perf_counter() - start))


def tell_heaps(program, rounds, scale, table):
    for name, model, goal in HEAPS:
        kind, n, *formulation = model.split("-")
        with tempfile.TemporaryDirectory() as folder:
            heap.make_mesh(Path(folder) / "heap.g", kind, int(n))
            (Path(folder) / "heap.i").write_text(heap.make_deck(kind, "".join(formulation), 100))
            least = min(run_heap(program, folder) for _ in range(min(rounds, 3)))
        table.row(name, goal / scale, least, "ns a face", False)


def least_seconds(command, folder, repeats=20):
    """Seconds that a program computes from start to end, the least of several runs."""
    least = float("inf")
    for _ in range(repeats):
        before = computed()
        subprocess.run(command, cwd=folder, check=True, stdout=subprocess.DEVNULL, env=os.environ | {"OMP_NUM_THREADS": "1"})
        least = min(least, computed() - before)
    return least


def write_cube(n, path):
    mesh = MeshMaker()
    mesh.hexes("cube", (0, 0, 0), (1, 1, 1), (n, n, n))
    mesh.write(path)


def tell_program(program, scale, table):
    with tempfile.TemporaryDirectory() as folder:
        write_cube(1, Path(folder) / "cube.g")
        (Path(folder) / "cube.i").write_text(CUBE)
        table.row("--check of a unit cube, computed", 15 / scale, 1e3 * least_seconds([program, "cube.i", "--check"], folder), "ms", False)
        table.row("100 steps of one element, computed", 30 / scale, 1e3 * least_seconds([program, "cube.i"], folder), "ms", False)


def tell_large(program, scale, table):
    """1,000,000 hexahedra whose skin is in contact, for some steps: memory at the peak, and time before the first step."""
    n = 100
    before = "   begin solution termination\n"
    with tempfile.TemporaryDirectory() as folder:
        # In a process of its own: the memory of this one would count as the program's.
        maker = multiprocessing.Process(target=write_cube, args=(n, Path(folder) / "cube.g"))
        maker.start()
        maker.join()
        (Path(folder) / "cube.i").write_text(CUBE.replace(before, CONTACT_OF_SKIN + before).replace(">= 100", ">= 3"))
        begun = time.monotonic()
        run = subprocess.Popen([program, "cube.i"], cwd=folder, stdout=subprocess.PIPE, text=True,
                               env=os.environ | {"OMP_NUM_THREADS": "1"})
        steps = heap.number(r"\n  whole run +([\d.]+) s", run.stdout.read())
        _, status, used = os.wait4(run.pid, 0)
        seconds = time.monotonic() - begun - steps
    if status != 0:
        sys.exit(f"1,000,000 hexahedra: status {status}")
    table.row("1,000,000 hexahedra in contact, memory", 500, 1024 * used.ru_maxrss / n ** 3, "bytes each", False)
    table.row("the same, before its first step", 1.5 / scale, seconds, "s", False)


def main():
    sys.stdout.reconfigure(line_buffering=True)
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build", type=Path)
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--count", action="store_true")
    parser.add_argument("--without", nargs="+", choices=PARTS, default=[])
    arguments = parser.parse_args()
    parts = [part for part in PARTS if part not in arguments.without]
    folder, program = (arguments.build / "tests" / "bench").resolve(), (arguments.build / "app" / "contactsim").resolve()
    if arguments.count:
        count_operations(folder / "contactsim_kernels")
    options = ["--impact"] * ("impact" in parts)
    found = kernel_lines.run(folder / "contactsim_kernels", "--two-threads", "--rounds", arguments.rounds, *options)
    limits, table = found.pop("limits"), Table()
    impacts = {name: found.pop(name)["share"] for name in list(found) if name.startswith("impact")}
    scale = limits["fused"] / FUSED_OF_GOALS
    tell_limits(limits)
    print(f"Goals in element rates and times are scaled by {scale:.2f}, the fused rate over {FUSED_OF_GOALS / 1e9} GFLOP/s.")
    tell_kernels(found, scale, table)
    for name, share in impacts.items():
        table.row(f"{name}: contact over the rest", 8, 100 * share, "%", False)
    embree = folder / "contactsim_embree_bench"
    if "search" in parts and embree.exists():
        tell_search(kernel_lines.run_all(embree, "--rounds", 4 * arguments.rounds)["search"], table)
    if "skin" in parts:
        tell_skin(folder / "contactsim_skin_of_file", arguments.rounds, table)
    if "heap" in parts:
        tell_heaps(program, arguments.rounds, scale, table)
    if "program" in parts:
        tell_program(program, scale, table)
    if "large" in parts:
        tell_large(program, scale, table)
    tell_rooflines(with_operations(found), limits)
    print(f"\n{table.missed} goals are missed.")


if __name__ == "__main__":
    main()
