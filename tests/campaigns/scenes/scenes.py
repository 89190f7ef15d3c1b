# SPDX-License-Identifier: BSD-3-Clause
"""Campaign of scenes: random bodies, laws and speeds keep momentum and energy, pass through nobody, and do the same in other
frames, numbers and units. scenes/README.md says what is drawn and held."""
import collections
import json
import os
import pathlib
import re
import shutil
import sys

os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")
HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent), str(HERE.parents[2] / "decks"), str(HERE.parents[2] / "decks/verification")]

from campaign import Campaign, scratch_folder  # noqa: E402
from draw import draw_scene  # noqa: E402
from evaluate import evaluate  # noqa: E402
from shrink import shrink  # noqa: E402
from variants import VARIANTS  # noqa: E402


def add_arguments(parser):
    parser.add_argument("--shrink", type=float, default=20, help="seconds for each scene that is made small")
    parser.add_argument("--alike", type=int, default=2, help="scenes made small of each property that fails")
    parser.add_argument("--variant", choices=list(VARIANTS), help="in place of one at random")
    parser.add_argument("--scene", type=pathlib.Path, help="judge this scene.json of a finding, make it small, and end")
    parser.add_argument("--property", help="that the smaller scene fails too, in place of the first one")
    parser.add_argument("--list", action="store_true", help="a line for every scene: difference of the variant, what is told")


# What a smaller scene must have left of the amount by which a property fails: it is to show the same, not what just fails.
LEFT_OVER = 0.3


def amount(text):
    """The first number that the text of a failure tells, 1 without any."""
    found = re.search(r"(?:by|is|out|reaches) ([0-9.]+(?:e[-+]?[0-9]+)?)", text)
    return float(found.group(1)) if found else 1.0


class Judge:
    """Judges scenes in a folder."""

    def __init__(self, campaign, folder):
        self.campaign, self.folder, self.shrunk = campaign, folder, collections.Counter()
        self.counts = collections.Counter()

    def judge(self, case):
        return evaluate(self.campaign.program, case["scene"], case["variant"], case["seed"], self.folder)

    def count(self, case, verdict):
        self.counts[case["variant"]] += 1
        for name in [verdict.ended] if verdict.ended else [*verdict.failed, *verdict.told]:
            self.counts[name] += 1
        if self.campaign.arguments.list:
            told = "; ".join(f"{n}: {t}" for n, t in verdict.told.items())
            print(f"case {self.campaign.case} {case['variant']} {verdict.difference:.1e} {verdict.ended} {told}", flush=True)

    def report(self, case, verdict):
        """Makes the scene small while its first property fails, and keeps both."""
        name = self.campaign.arguments.property or next(iter(verdict.failed))
        text = "; ".join(f"{n}: {t}" for n, t in verdict.failed.items())
        if self.shrunk[name] < self.campaign.arguments.alike:
            self.shrunk[name] += 1

            def fails(scene):
                smaller = self.judge(case | {"scene": scene})
                return (name in smaller.failed and smaller.overlaps <= verdict.overlaps
                        and amount(smaller.failed[name]) >= LEFT_OVER * amount(verdict.failed[name]))
            small, n_tried = shrink(case["scene"], fails, self.campaign.arguments.shrink)
            text += f" (made small in {n_tried} runs)"
            self._keep(case, case | {"scene": small}, text)
        else:
            self._keep(case, case, text)

    def _keep(self, first, case, text):
        verdict = self.judge(case)
        kept = self.folder / "kept"
        shutil.rmtree(kept, ignore_errors=True)
        kept.mkdir()
        for part in ("first", "second"):
            for file in (self.folder / part).glob("scene.[ig]"):
                shutil.copy(file, kept / f"{'deck' if part == 'first' else 'variant'}{file.suffix}")
        (kept / "deck.i").write_text((kept / "deck.i").read_text().replace("scene.", "deck."))
        if (kept / "variant.i").exists():
            (kept / "variant.i").write_text((kept / "variant.i").read_text().replace("scene.", "variant."))
        (kept / "scene.json").write_text(json.dumps(case, indent=1))
        (kept / "drawn.json").write_text(json.dumps(first, indent=1))
        lines = [f"{n}: {t}" for n, t in verdict.failed.items()] or [text]
        (kept / "note.txt").write_text("\n".join([f"variant: {case['variant']}", *lines, "", "contactsim deck.i",
                                                  "scenes.py PROGRAM SOURCE --scene scene.json", ""]))
        self.campaign.finding(text, kept)


def judge_one(campaign, judge):
    """The scene of the command line."""
    case = json.loads(campaign.arguments.scene.read_text())
    campaign.case, campaign.n_cases = campaign.arguments.scene.resolve().parent.name, 1
    verdict = judge.judge(case)
    judge.count(case, verdict)
    if verdict.failed:
        judge.report(case, verdict)
    campaign.end(", ".join([verdict.ended, *verdict.told]))


def main():
    campaign = Campaign("scenes", __doc__, add_arguments)
    with scratch_folder() as folder:
        judge = Judge(campaign, pathlib.Path(folder))
        if campaign.arguments.scene:
            judge_one(campaign, judge)
        for rng in campaign.cases():
            scene = draw_scene(rng)
            case = {"scene": scene, "variant": campaign.arguments.variant or rng.choice(list(VARIANTS)),
                    "seed": f"{campaign.arguments.seed} {campaign.case}"}
            verdict = judge.judge(case)
            judge.count(case, verdict)
            if verdict.failed:
                judge.report(case, verdict)
    campaign.end(", ".join(f"{name}: {n}" for name, n in sorted(judge.counts.items())))


if __name__ == "__main__":
    main()
