# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Triangle meshes as numpy arrays: files, areas, and distances along the surface."""

import os
import sys
import tempfile

try:
    import numpy as np
    from scipy.sparse import coo_matrix, csr_matrix
    from scipy.sparse.csgraph import dijkstra
except ImportError:
    sys.exit("python3-numpy or python3-scipy is missing: install them by "
             "scripts/install_packages.sh tables and run the tables with /usr/bin/python3")

PLY_TYPES = {"float": "f4", "float32": "f4", "double": "f8", "float64": "f8", "uchar": "u1",
             "uint8": "u1", "int": "i4", "int32": "i4", "uint": "u4", "uint32": "u4"}


class Surface:
    """Vertices (n, 3) and faces (m, 3)."""

    def __init__(self, vertices, faces):
        self.vertices, self.faces = np.asarray(vertices, float), np.asarray(faces, int)

    @property
    def face_areas(self):
        """Of a face with a corner that is not a number 0."""
        a, b, c = (self.vertices[self.faces[:, k]] for k in range(3))
        return np.nan_to_num(np.linalg.norm(np.cross(b - a, c - a), axis=1) / 2)

    @property
    def area(self):
        return self.face_areas.sum()

    @property
    def vertex_areas(self):
        """A third of the area of the faces around each vertex."""
        return np.bincount(self.faces.ravel(), np.repeat(self.face_areas / 3, 3),
                           len(self.vertices))


def read_off(path):
    words = path.read_text().split()
    vertices, faces = int(words[1]), int(words[2])
    end = 4 + 3 * vertices
    corners = np.array(words[end:end + 4 * faces], int).reshape(faces, 4)
    return Surface(np.array(words[4:end], float).reshape(vertices, 3), corners[:, 1:])


def ply_elements(file):
    """Name, count and numpy type of each element, of which lists have three entries."""
    elements = []
    for line in file:
        words = line.decode().split()
        if words[0] == "format" and words[1] != "binary_little_endian":
            raise SystemExit(f"{file.name} is no binary little-endian PLY file")
        if words[0] == "element":
            elements.append((words[1], int(words[2]), []))
        elif words[0] == "property" and words[1] == "list":
            elements[-1][2].extend([("count", PLY_TYPES[words[2]]),
                                    ("corners", PLY_TYPES[words[3]], (3,))])
        elif words[0] == "property":
            elements[-1][2].append((words[2], PLY_TYPES[words[1]]))
        elif words[0] == "end_header":
            return elements
    raise SystemExit(f"{file.name} ends within its header")


def read_ply(path):
    with path.open("rb") as file:
        data = {}
        for name, count, fields in ply_elements(file):
            kind = np.dtype([(field[0], "<" + field[1], *field[2:]) for field in fields])
            data[name] = np.frombuffer(file.read(count * kind.itemsize), kind, count)
    if (data["face"]["count"] != 3).any():
        raise SystemExit(f"{path} has faces that are no triangles")
    return Surface(np.stack([data["vertex"][axis] for axis in "xyz"], 1), data["face"]["corners"])


def read_surface(path):
    return read_off(path) if path.suffix == ".off" else read_ply(path)


def write_ply(path, surface):
    """Coordinates have 64 bits. The file appears whole or not at all."""
    head = ["ply", "format binary_little_endian 1.0", f"element vertex {len(surface.vertices)}",
            *(f"property double {axis}" for axis in "xyz"), f"element face {len(surface.faces)}",
            "property list uchar int vertex_indices", "end_header", ""]
    faces = np.empty(len(surface.faces), [("count", "u1"), ("corners", "<i4", (3,))])
    faces["count"], faces["corners"] = 3, surface.faces
    path.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.NamedTemporaryFile(dir=path.parent, delete=False) as file:
        file.write("\n".join(head).encode() + surface.vertices.astype("<f8").tobytes() +
                   faces.tobytes())
    os.replace(file.name, path)


def edges_and_opposites(faces):
    """Each edge of each face, ends in order, and the corner opposite to it."""
    edges = np.concatenate([faces[:, [1, 2]], faces[:, [2, 0]], faces[:, [0, 1]]])
    return np.sort(edges, axis=1), faces.T.ravel()


def links_across(vertices, edges, opposites):
    """Pairs of corners opposite to the same edge, and their distance in the unfolded plane, where
    the straight line between them crosses the edge."""
    order = np.lexsort(edges.T)
    edges, opposites = edges[order], opposites[order]
    same = np.flatnonzero((edges[1:] == edges[:-1]).all(1))
    start, end = vertices[edges[same, 0]], vertices[edges[same, 1]]
    length = np.linalg.norm(end - start, axis=1)
    along, away = [], []
    for corner in (opposites[same], opposites[same + 1]):
        offset = vertices[corner] - start
        t = (offset * (end - start)).sum(1) / length
        along.append(t)
        away.append(np.sqrt(np.maximum((offset ** 2).sum(1) - t ** 2, 0)))
    crossing = along[0] + (along[1] - along[0]) * away[0] / (away[0] + away[1])
    inside = (crossing >= 0) & (crossing <= length)
    distance = np.hypot(along[1] - along[0], away[0] + away[1])
    return np.stack([opposites[same], opposites[same + 1]], 1)[inside], distance[inside]


def link_graph(surface):
    """Vertices joined by edges, and by straight lines across two triangles."""
    finite = np.isfinite(surface.vertices[surface.faces]).all((1, 2))
    edges, opposites = edges_and_opposites(surface.faces[finite])
    with np.errstate(divide="ignore", invalid="ignore"):
        across, lengths = links_across(surface.vertices, edges, opposites)
    edges = np.unique(edges, axis=0)
    ends = np.concatenate([edges, across])
    edge_lengths = np.linalg.norm(np.subtract(*surface.vertices[edges.T]), axis=1)
    lengths = np.maximum(np.concatenate([edge_lengths, lengths]), 1e-300)
    n = len(surface.vertices)
    graph = coo_matrix((lengths, ends.T), (n, n))
    return without_longer_twins(graph, n)


def without_longer_twins(graph, n):
    """Of several links of the same vertices the shortest, as sums of them would be of no use."""
    low, high = np.minimum(graph.row, graph.col), np.maximum(graph.row, graph.col)
    order = np.lexsort((graph.data, high, low))
    low, high, data = low[order], high[order], graph.data[order]
    first = np.ones(len(low), bool)
    first[1:] = (low[1:] != low[:-1]) | (high[1:] != high[:-1])
    first &= low != high
    return csr_matrix((data[first], (low[first], high[first])), (n, n))


def entering(start_distance, end_distance, start, end, points):
    """Distances of points in the planes of triangles from a source whose distances from both ends
    of an edge are known, by the straight way over that edge; infinite where there is none."""
    length = np.linalg.norm(end - start, axis=1)
    direction = (end - start) / length[:, None]
    source_along = (length ** 2 + start_distance ** 2 - end_distance ** 2) / (2 * length)
    source_away = np.sqrt(np.maximum(start_distance ** 2 - source_along ** 2, 0))
    along = ((points - start) * direction).sum(1)
    away = np.sqrt(np.maximum(((points - start) ** 2).sum(1) - along ** 2, 0))
    share = np.divide(source_away, source_away + away, out=np.zeros_like(away),
                      where=source_away + away > 0)
    crossing = source_along + share * (along - source_along)
    distance = np.hypot(along - source_along, away + source_away)
    return np.where((crossing >= 0) & (crossing <= length), distance, np.inf)


def within_triangles(corner_distances, corners, points):
    """Distances (k) of points in triangles (k, 3, 3) from sources whose distances from the corners
    (k, 3) are known."""
    offsets = np.linalg.norm(corners - points[:, None], axis=2)
    ways = [corner_distances[:, k] + offsets[:, k] for k in range(3)]
    for a, b in ((0, 1), (1, 2), (2, 0)):
        ways.append(entering(corner_distances[:, a], corner_distances[:, b], corners[:, a],
                             corners[:, b], points))
    return np.fmin.reduce(ways)


class Distances:
    """Geodesic distances on a surface, by Dijkstra's algorithm on its graph of links."""

    def __init__(self, surface):
        self.surface, self.graph = surface, link_graph(surface)

    def between(self, vertices, faces, weights, chunk=50):
        """From each vertex to the point of the same line, given by a face and weights (k, 3);
        straight where there is no way."""
        corners, points = self.surface.faces[faces], self.points(faces, weights)
        reached = np.empty((len(vertices), 3))
        starts, start_of = np.unique(vertices, return_inverse=True)
        for first in range(0, len(starts), chunk):
            rows = np.flatnonzero((start_of >= first) & (start_of < first + chunk))
            table = dijkstra(self.graph, False, starts[first:first + chunk])
            reached[rows] = table[start_of[rows, None] - first, corners[rows]]
        with np.errstate(invalid="ignore", divide="ignore"):
            result = within_triangles(reached, self.surface.vertices[corners], points)
        straight = np.linalg.norm(points - self.surface.vertices[vertices], axis=1)
        return np.where(np.isfinite(result), result, straight)

    def points(self, faces, weights):
        corners = self.surface.vertices[self.surface.faces[faces]]
        return (weights[:, :, None] * corners).sum(1)
