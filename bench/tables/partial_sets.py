# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Pairs of shapes of which parts have no counterpart, and of whole ones, with the truth."""

import dataclasses
import functools
import pathlib
import typing
import zlib

import numpy as np

import data_sets
from surfaces import Surface, read_surface, write_ply

UNCUT_SETS = {"tr": "faust5k", "horse_": "horse_gallop", "elephant": "elephant42k"}


@dataclasses.dataclass
class Truth:
    """Points of a source and where they belong on the target, from 0; -1 where nothing does.
    `symmetric`: the same of the left-right mirrored points, if known."""
    source: np.ndarray
    target: np.ndarray
    symmetric: typing.Optional[np.ndarray] = None
    every_vertex: bool = False  # The points are the vertices of the source in order.


class Pair(typing.NamedTuple):
    """`source` and `target` are SET/NAME."""
    data: pathlib.Path
    set: str
    source: str
    target: str

    @property
    def name(self):
        return f"{short(self.source)}__{short(self.target)}"

    @property
    def group(self):
        """What is reported on its own within a set."""
        if self.set == "partial_cuts":
            kinds = ["piece" if is_piece(name) else "full" for name in (self.source, self.target)]
            return " to ".join(kinds)
        if self.set == "topo_kids":
            return "to the rest pose" if self.target.endswith("null") else "between poses"
        return ""


def short(name):
    return name.split("/")[1]


def is_piece(name):
    return name.startswith("partial_cuts/")


def uncut(name):
    """The shape that a piece was cut from, or the shape itself."""
    if not is_piece(name):
        return name
    shape = short(name).rsplit("_", 1)[0]
    folder = next((folder for begin, folder in UNCUT_SETS.items() if shape.startswith(begin)),
                  "tosca5k")
    return f"{folder}/{shape}"


def mesh_file(data, name):
    return next(path for path in (data / f"{name}{ending}" for ending in (".ply", ".off"))
                if path.exists())


def listed_pairs(data, title):
    lines = (data / title / "pairs.txt").read_text().split()
    names = [name if "/" in name else f"{title}/{name}" for name in lines]
    return [Pair(data, title, *both) for both in zip(names[::2], names[1::2])]


LISTED = ("partial_cuts", "partial_smal", "topo_kids", "smal5k", "skulls")
DRAWN = ("faust5k", "tosca5k", "horse_gallop")


def all_pairs(data, title):
    if title in LISTED:
        return listed_pairs(data, title)
    return [Pair(data, title, f"{title}/{pair.source}", f"{title}/{pair.target}")
            for pair in data_sets.pairs_with_truth(data)[title]]


def numbers(path, first):
    return np.loadtxt(path, int, ndmin=1) - first


def template(data, name, ending=".vts"):
    """The vertex of each template point, -1 where it was cut away; None without a file."""
    folder, shape = name.split("/")
    path = data / folder / "corres" / (shape + ending)
    return numbers(path, 1) if path.exists() else None


def mirrored_template(data, name):
    """The vertex of the left-right mirror image of each template point; None if unknown."""
    whole, mirrored = template(data, uncut(name)), template(data, uncut(name), ".sym.vts")
    if mirrored is None or not is_piece(name):
        return mirrored
    kept = np.full(max(whole.max(), mirrored.max()) + 1, -1)
    kept[whole] = template(data, name)
    return kept[mirrored]


def truth_of(pair, source_vertices):
    folder = pair.data / pair.set
    if pair.set in ("partial_smal", "topo_kids"):
        return Truth(np.arange(source_vertices), numbers(folder / "maps" / f"{pair.name}.txt", 0),
                     every_vertex=True)
    if pair.set == "skulls":
        return Truth(*(numbers(folder / "landmarks" / f"{short(name)}.txt", 0)
                       for name in (pair.source, pair.target)))
    source, target = (template(pair.data, name) for name in (pair.source, pair.target))
    mirrored = mirrored_template(pair.data, pair.target)
    there = source >= 0
    return Truth(source[there], target[there], None if mirrored is None else mirrored[there])


def turning(generator):
    """A rotation, all equally probable."""
    w, x, y, z = (q := generator.normal(size=4)) / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def turned(surface, name):
    """Turned and shifted by about its size, always the same for a name."""
    generator = np.random.default_rng(zlib.crc32(name.encode()))
    rotation = turning(generator)
    low, high = np.nanmin(surface.vertices, 0), np.nanmax(surface.vertices, 0)
    shift = generator.normal(size=3) * np.linalg.norm(high - low)
    return Surface((surface.vertices - (low + high) / 2) @ rotation.T + shift, surface.faces)


def turned_file(pair, name, folder):
    """The mesh file of a turned shape, written if it is not there yet."""
    path = folder / f"{name}.ply"
    if not path.exists():
        write_ply(path, turned(read_surface(mesh_file(pair.data, name)), name))
    return path


@functools.lru_cache(None)
def area_of(data, name):
    return read_surface(mesh_file(data, name)).area


def reference_area(pair, source, target):
    """What errors are relative to: the area of the target; for pieces that of the larger of the
    uncut shapes, which is 1 in partial_smal."""
    if pair.set == "partial_smal":
        return 1
    if pair.set == "partial_cuts":
        return max(area_of(pair.data, uncut(name)) for name in (pair.source, pair.target))
    return target.area
