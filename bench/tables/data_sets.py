# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Pairs of shapes that methods are measured on, drawn the same in every run."""

import collections
import itertools
import random
import sys

from common import run, truth_options

TOSCA_KINDS = ("cat", "centaur", "dog", "horse", "wolf")


class Pair(collections.namedtuple("Pair", "folder ending source target")):
    """Two shapes of a data set."""

    @property
    def name(self):
        return f"{self.source} {self.target}"

    @property
    def meshes(self):
        return [self.folder / (name + self.ending) for name in (self.source, self.target)]

    @property
    def truth(self):
        """Options of the programs for the ground truth."""
        return truth_options(self.folder, self.source, self.target)

    def write_exact_map(self, path):
        """Writes the exact truth as a map; whether the set has one."""
        if not (self.folder / "exact").is_dir():
            return False
        names = [f"{self.folder.name}/{name}" for name in (self.source, self.target)]
        run([sys.executable, "-B", self.folder.parent / "exact_truth.py", *names, path])
        return True

    def error_unit(self, target_area):
        """What errors over sqrt(area) of the target are to be multiplied with."""
        return 1


class AcrossPair(collections.namedtuple("AcrossPair", "source_mesh target_mesh")):
    """Shapes of two classes, between which no truth is known."""

    truth = ()

    def error_unit(self, target_area):
        return 1

    @property
    def name(self):
        return f"{self.source_mesh.stem} {self.target_mesh.stem}"

    @property
    def meshes(self):
        return list(self)


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


def gallop_pairs(data):
    """Every second frame as source, the frame five later cyclically as target: ten pairs."""
    frames = [f"horse_{i:02}" for i in range(1, 24, 2)]
    return [Pair(data / "horse_gallop", ".ply", frames[i], frames[(i + 5) % 12])
            for i in range(10)]


def jumping_pairs(data):
    frames = [f"jump_{i:03}" for i in (1, 20, 40, 60, 80, 100)]
    return [Pair(data / "jumping_man", ".ply", frames[i], frames[(i + 2) % 6]) for i in range(6)]


def mesh_files(folder, kind=""):
    names, ending = shapes(folder, kind)
    return [folder / (name + ending) for name in names]


def across_classes(sources, targets, count):
    return draw([AcrossPair(*both) for both in itertools.product(sources, targets)], count)


def dog_wolf_pairs(data):
    tosca = data / "tosca5k"
    return across_classes(mesh_files(tosca, "dog"), mesh_files(tosca, "wolf"), 6)


def wolf_gallop_pairs(data):
    return across_classes(mesh_files(data / "tosca5k", "wolf"), mesh_files(data / "horse_gallop"),
                          6)


def person(name):
    """Which of the people of FAUST a shape is: ten poses each, in order."""
    return int(name.removeprefix("tr_reg_")) // 10


def same_person(pair):
    return person(pair.source) == person(pair.target)


def modern_pairs(data, quick=False):
    """The pairs that all methods are compared on: of faust5k half within a person, half across."""
    tosca = [pair for kind in TOSCA_KINDS for pair in within(data / "tosca5k", kind)]
    people = within(data / "faust5k")
    one = [pair for pair in people if same_person(pair)]
    two = [pair for pair in people if not same_person(pair)]
    tosca_count, people_count = (1, 1) if quick else (15, 10)
    return {"tosca5k": draw(tosca, tosca_count),
            "faust5k": draw(one, people_count) + draw(two, people_count)}
