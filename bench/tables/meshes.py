# SPDX-License-Identifier: MIT
# SPDX-FileCopyrightText: 2026 The isomatch authors
"""Shapes with ground truth that are changed in ways that a matching must not depend on."""

import dataclasses
import math
import pathlib
import random


@dataclasses.dataclass(frozen=True)
class TrueShape:
    """A mesh and the vertex of each template point, of each mirrored template point: from 0."""
    vertices: list
    faces: list
    truth: list
    symmetric: list

    def changed(self, **fields):
        return dataclasses.replace(self, **fields)


def read_truth(path):
    return [int(line) - 1 for line in path.read_text().split()]


def read_shape(folder, name):
    words = iter((folder / f"{name}.off").read_text().split())
    if next(words) != "OFF":
        raise SystemExit(f"{folder / name}.off is no OFF file")
    num_vertices, num_faces, _ = (int(next(words)) for _ in range(3))
    vertices = [tuple(float(next(words)) for _ in range(3)) for _ in range(num_vertices)]
    faces = [tuple(int(next(words)) for _ in range(4))[1:] for _ in range(num_faces)]
    truths = [read_truth(folder / "corres" / f"{name}{ending}") for ending in (".vts", ".sym.vts")]
    return TrueShape(vertices, faces, *truths)


def write_shape(shape, folder, name):
    """Writes NAME.off, NAME.vts and NAME.sym.vts."""
    lines = ["OFF", f"{len(shape.vertices)} {len(shape.faces)} 0"]
    lines += ["%r %r %r" % vertex for vertex in shape.vertices]
    lines += ["3 %d %d %d" % face for face in shape.faces]
    folder = pathlib.Path(folder)
    (folder / f"{name}.off").write_text("\n".join(lines) + "\n")
    for ending, truth in ((".vts", shape.truth), (".sym.vts", shape.symmetric)):
        (folder / f"{name}{ending}").write_text("".join(f"{vertex + 1}\n" for vertex in truth))


def with_positions(shape, position):
    return shape.changed(vertices=[tuple(position(vertex)) for vertex in shape.vertices])


def scaled(shape, factor=37.5):
    return with_positions(shape, lambda p: (factor * c for c in p))


def moved(shape):
    """Turned by 2 radians about (1, 2, 2) and moved by five times its height."""
    axis, angle = (1 / 3, 2 / 3, 2 / 3), 2.0
    shift = 5 * (max(p[1] for p in shape.vertices) - min(p[1] for p in shape.vertices))
    cos, sin = math.cos(angle), math.sin(angle)

    def position(p):
        dot = sum(a * c for a, c in zip(axis, p))
        cross = [axis[k - 2] * p[k - 1] - axis[k - 1] * p[k - 2] for k in range(3)]
        return (cos * p[k] + sin * cross[k] + (1 - cos) * dot * axis[k] + shift for k in range(3))

    return with_positions(shape, position)


def turned_over(shape):
    """Every face seen from the other side."""
    return shape.changed(faces=[(a, c, b) for a, b, c in shape.faces])


def mirrored(shape):
    """Reflected, with faces that are seen from outside as before."""
    return turned_over(with_positions(shape, lambda p: (-p[0], p[1], p[2])))


def relabelled(shape):
    generator = random.Random(1)
    old_vertex = generator.sample(range(len(shape.vertices)), len(shape.vertices))
    new_vertex = {old: new for new, old in enumerate(old_vertex)}
    faces = [tuple(new_vertex[v] for v in face) for face in shape.faces]
    generator.shuffle(faces)
    return TrueShape([shape.vertices[v] for v in old_vertex], faces,
                     [new_vertex[v] for v in shape.truth],
                     [new_vertex[v] for v in shape.symmetric])


def subdivided(shape):
    """Each triangle divided into four at the middles of its edges; old vertices keep their numbers."""
    vertices, faces, middles = list(shape.vertices), [], {}

    def middle(a, b):
        edge = (min(a, b), max(a, b))
        if edge not in middles:
            middles[edge] = len(vertices)
            vertices.append(tuple((p + q) / 2 for p, q in zip(vertices[a], vertices[b])))
        return middles[edge]

    for a, b, c in shape.faces:
        ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
        faces += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
    return shape.changed(vertices=vertices, faces=faces)


def mean_edge(shape):
    lengths = [math.dist(shape.vertices[face[k]], shape.vertices[face[k - 1]])
               for face in shape.faces for k in range(3)]
    return sum(lengths) / len(lengths)


def sqrt_area(shape):
    def area(face):
        a, b, c = (math.dist(shape.vertices[face[k]], shape.vertices[face[k - 1]])
                   for k in range(3))
        s = (a + b + c) / 2
        return math.sqrt(max(0, s * (s - a) * (s - b) * (s - c)))

    return math.sqrt(sum(map(area, shape.faces)))


def noisy(shape, sigma):
    """Every coordinate moved by a Gaussian of this standard deviation."""
    generator = random.Random(1)
    return with_positions(shape, lambda p: (c + generator.gauss(0, sigma) for c in p))
