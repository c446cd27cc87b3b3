# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""The sets of pairs that all methods are compared on, drawn the same in every run."""

import functools
import math

import data_sets
import partial_sets

# Whose shapes stand aligned, so that they are turned before a method can profit from it.
ALIGNED = ("smal5k", "partial_smal")


class ListedPair:
    """A pair of the list that comes with a set, as the methods get it."""

    def __init__(self, pair, folder):
        self.listed, self.folder = pair, folder
        self.name = f"{partial_sets.short(pair.source)} {partial_sets.short(pair.target)}"

    @property
    def meshes(self):
        names = (self.listed.source, self.listed.target)
        if self.listed.set not in ALIGNED:
            return [partial_sets.mesh_file(self.listed.data, name) for name in names]
        return [partial_sets.turned_file(self.listed, name, self.folder / "turned")
                for name in names]

    @property
    def truth(self):
        folder = self.listed.data / self.listed.set
        if self.listed.set in ("partial_smal", "topo_kids"):
            return ["--gt-map", folder / "maps" / f"{self.listed.name}.txt"]
        lists = [self.listed.data / set / "corres" / f"{name}.vts" for set, name in
                 (name.split("/") for name in (self.listed.source, self.listed.target))]
        return ["--gt-source", lists[0], "--gt-target", lists[1]]

    @functools.cached_property
    def reference_area(self):
        """Errors are relative to its square root: pieces count as what they were cut from."""
        surfaces = [partial_sets.read_surface(path) for path in self.meshes]
        return partial_sets.reference_area(self.listed, *surfaces)

    def error_unit(self, target_area):
        """What errors over sqrt(area) of the target are to be multiplied with."""
        return math.sqrt(target_area / self.reference_area)


def listed(data, title, count, folder):
    pairs = partial_sets.listed_pairs(data, title)
    if title == "topo_kids":  # The rest pose has five times as many vertices, too many for some rivals.
        pairs = [pair for pair in pairs if not pair.target.endswith("null")]
    return [ListedPair(pair, folder) for pair in data_sets.draw(pairs, count)]


def all_sets(data, quick, folder):
    """Pairs by the title of their set. `folder`: for shapes that are turned."""
    def first(pairs):
        return pairs[:1] if quick else pairs

    sets = dict(data_sets.modern_pairs(data, quick))
    sets["horse_gallop"] = first(data_sets.gallop_pairs(data))
    sets["jumping_man"] = first(data_sets.jumping_pairs(data))
    for title, count in (("smal5k", 12), ("partial_cuts", 12), ("partial_smal", 8),
                         ("topo_kids", 6)):
        sets[title] = listed(data, title, 1 if quick else count, folder)
    return sets
