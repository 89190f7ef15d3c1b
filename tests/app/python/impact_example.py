#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# %% [markdown]
# A ball hits a plate, from Python: cells of a notebook, and a test.
#
# usage: impact_example.py DECKS      in an empty folder; the package contactsim must be found

# %%
import os
import sys

import numpy as np

import contactsim

decks = sys.argv[1]
print("contactsim", contactsim.__version__)

# %% [markdown]
# Who owns which face, before anything moves.

# %%
run = contactsim.Simulation(os.path.join(decks, "impact.i"), os.path.join(decks, "impact.g"), define={"speed": 40},
                            output="impact.e")
facets = run.facets()
for name in run.surfaces:
    own = facets["surface"] == name
    print(f"{name:10} {own.sum():5} facets, area {facets['area'][own].sum():.6g}")
assert run.surfaces == ["patch", "plate", "ball"]
assert ("patch", "ball") in run.pairs
patch = facets["surface"] == "patch"
assert patch.sum() == 96
target = run.mesh.side_sets["target"]
rows = np.column_stack([facets["element"], facets["side"]])[patch]
assert {tuple(row) for row in rows} == {tuple(row) for row in target}  # the side set, element ids and sides
assert [problem.id for problem in run.warnings] == ["surface-overlap"]
assert run.warnings[0].line == 78 and run.warnings[0].file.endswith("impact.i")

# %% [markdown]
# Step by step: the impulse that the plate gives to the ball is what the ball's momentum changes by.

# %%
ball = np.unique(run.mesh.blocks["ball"]["nodes"])
run.begin()
start = run.velocities[ball, 2].copy()
assert np.allclose(start, -40 / np.sqrt(2))
impulse, peak = 0.0, 0.0
while run.time < 6e-5:
    force = run.contact_forces[ball, 2].sum()
    impulse += force * run.time_step
    peak = max(peak, force)
    run.step()
volume = 4 / 3 * np.pi * 0.01**3
gained = 7800 * volume * (run.velocities[ball, 2].mean() - start.mean())
print(f"{run.n_steps} steps to {run.time:.3g}: peak force {peak:.5g}, impulse {impulse:.4g}, gained {gained:.4g}")
assert peak > 1000 and abs(impulse - gained) < 0.1 * impulse  # the mesh's ball is smaller than a sphere

# %% [markdown]
# To the end, then what was written.

# %%
run.run()
assert run.is_over
energies = run.energies
print({name: round(value, 4) for name, value in energies.items()})
assert abs(energies["error"]) < 1e-3 * energies["internal"]
results = contactsim.Results("impact.e")
assert results.times[-1] == run.time
moved = results.nodal("displ") if "displ_x" in results.nodal_names else results.nodal("displacement")
assert np.allclose(moved, run.positions - run.mesh.coordinates)
assert np.nanmax(results.element("von_mises")) > 2e8
assert "impact.e" in run.outputs

# %% [markdown]
# Mistakes are exceptions with their places in the deck.

# %%
with open("wrong.i", "w", encoding="utf-8") as file:
    file.write(open(os.path.join(decks, "impact.i"), encoding="utf-8").read().replace("skin all", "skinn all"))
try:
    contactsim.Simulation("wrong.i")
    raise AssertionError("a wrong deck is taken")
except contactsim.DeckError as error:
    print(error)
    problem = error.problems[0]
    assert problem.is_error and problem.file == "wrong.i" and problem.line == 78 and problem.column > 0
for wrong, kind in ((lambda: contactsim.read_mesh("nowhere.g"), contactsim.FileError),
                    (lambda: results.nodal("nothing"), KeyError),
                    (lambda: results.nodal("displ", 10**6), IndexError),
                    (lambda: contactsim.Simulation(os.path.join(decks, "impact.i"),
                                                   os.path.join(decks, "impact.g")).time, contactsim.DeckError)):
    try:
        wrong()
    except kind:
        continue
    raise AssertionError(f"expected {kind}")
