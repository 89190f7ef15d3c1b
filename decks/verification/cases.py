# SPDX-License-Identifier: BSD-3-Clause
"""What a verification case is, and the checks that every case of contact gets."""
from dataclasses import dataclass
from typing import Callable

import numpy as np

from runs import at_most

CASES = {}
FORMULATIONS = ("face_face", "node_face")


@dataclass
class Case:
    """Runs decks on a bench and returns checks; a refined case also takes a number of elements."""
    run: Callable
    is_long: bool
    refined: list


def case(is_long=False, refined=()):
    def add(function):
        CASES[function.__name__] = Case(function, is_long, list(refined))
        return function
    return add


def energy_share(run):
    """The largest energy that appears or goes missing, as a share of the largest term."""
    terms = ["kinetic_energy", "internal_energy", "external_energy", "contact_energy"]
    return np.max(np.abs(run["energy_error"])) / max(np.max(np.abs(run[term])) for term in terms if term in run.columns)


def net_share(vectors):
    """The largest sum of vectors over nodes [steps x nodes x 3] as a share of the largest sum of their sizes."""
    total = np.linalg.norm(np.sum(vectors, axis=1), axis=1)
    return np.max(total) / max(np.max(np.sum(np.linalg.norm(vectors, axis=2), axis=1)), 1e-300)


def momentum_share(run):
    momentum = run.nodal("mass")[..., None] * run.nodal("velocity")
    change = np.linalg.norm(np.sum(momentum, axis=1) - np.sum(momentum[0], axis=0), axis=1)
    return np.max(change) / np.max(np.sum(np.linalg.norm(momentum, axis=2), axis=1))


def angular_momentum(run):
    """[steps x 3], the turning of the nodes included."""
    orbit = run.nodal("mass")[..., None] * np.cross(run.nodal("coordinates"), run.nodal("velocity"))
    spin = run.nodal("rotational_mass")[..., None] * run.nodal("rotational_velocity")
    return np.sum(orbit + spin, axis=1)


def balances(runs, is_free=False, has_plane=False, has_friction=False, tolerance=0.01):
    """Net contact force and moment, momentum and energy; the worst of the runs.

    has_plane: the forces of an analytic plane are not in the nodes' sums.
    has_friction: friction across a gap leaves a moment.
    """
    checks = [at_most("energy balance", max(map(energy_share, runs)), tolerance)]
    forces = [run.nodal("force_contact") for run in runs]
    moments = [np.cross(run.nodal("coordinates"), f) + run.nodal("moment_contact") for run, f in zip(runs, forces)]
    if not has_plane:
        checks.append(at_most("net contact force", max(map(net_share, forces)), 1e-12))
    if not has_plane and not has_friction:
        checks.append(at_most("net contact moment", max(map(net_share, moments)), 1e-9))
    if is_free:
        checks.append(at_most("change of momentum", max(map(momentum_share, runs)), 1e-10))
    return checks
