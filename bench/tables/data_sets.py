# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Pairs of shapes that methods are measured on, drawn the same in every run."""

import collections
import itertools
import random

TOSCA_KINDS = ("cat", "centaur", "dog", "horse", "wolf")


class Pair(collections.namedtuple("Pair", "folder ending source target")):
    """Two shapes of a data set."""

    @property
    def name(self):
        return f"{self.source} {self.target}"

    @property
    def meshes(self):
        return [self.folder / (name + self.ending) for name in (self.source, self.target)]


def shapes(folder, kind=""):
    """The names of the shapes that begin with `kind`, and the ending of their files."""
    files = [path for path in folder.glob(f"{kind}*") if path.suffix in (".off", ".ply")]
    if not files:
        raise SystemExit(f"there are no shapes in {folder}")
    return [path.stem for path in files], files[0].suffix


def within(folder, kind=""):
    names, ending = shapes(folder, kind)
    return [Pair(folder, ending, *both) for both in itertools.permutations(names, 2)]


def across(folder, source_kind, target_kind):
    sources, ending = shapes(folder, source_kind)
    targets, _ = shapes(folder, target_kind)
    return [Pair(folder, ending, *both) for both in itertools.product(sources, targets)]


def draw(pairs, count):
    """`count` of `pairs` at random, or all of them in order."""
    pairs = sorted(pairs)
    return random.Random(0).sample(pairs, count) if count < len(pairs) else pairs


def pairs_with_truth(data):
    """The pairs of each set whose ground truth is known."""
    tosca = [pair for kind in TOSCA_KINDS for pair in within(data / "tosca5k", kind)]
    return {"faust5k": draw(within(data / "faust5k"), 60),
            "tosca5k": draw(tosca, 60),
            "horse_gallop": draw(within(data / "horse_gallop"), 20),
            "jumping_man": draw(within(data / "jumping_man"), 30),
            "tosca_cat28k": draw(within(data / "tosca_cat28k"), 6),
            "elephant42k": draw(within(data / "elephant42k"), 6)}


def pairs_across_classes(data):
    tosca = data / "tosca5k"
    return {"dog_wolf": draw(across(tosca, "dog", "wolf"), 6),
            "wolf_horse": draw(across(tosca, "wolf", "horse"), 6)}
