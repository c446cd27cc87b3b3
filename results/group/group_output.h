// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>
#include <vector>

#include "isomatch/group/shape_model.h"
#include "isomatch/mesh/mesh.h"
#include "results/folder/result_folder.h"

namespace isomatch::results {

/// A column of the table of shapes.
struct ShapeColumn {
  std::string name;
  /// Of each shape, empty where there is none.
  std::vector<std::string> values;
};

/// What a group leaves behind: N shapes of P points.
struct GroupOutput {
  /// Of the shapes, see `check_shape_names`.
  std::vector<std::string> names;
  CorrespondingPoints points;
  /// Which vertex of the template's mesh each point is.
  std::vector<int> template_vertices;
  /// Triangles between points, by the numbers of the points: the template's if the points are all
  /// its vertices. Without any, no meshes are written.
  std::vector<Face> faces;
  ShapeModel model;
  ModelQuality quality;
  /// How good the correspondence of each shape is, for scores.csv.
  std::vector<ShapeColumn> columns;
};

/// The faces of a mesh all of whose corners are among `vertices`, by their places in that list.
std::vector<Face> faces_between(const Mesh& mesh, const std::vector<int>& vertices);

/// Throws `InvalidInput` unless all names differ and can be those of files, endings aside.
void check_shape_names(const std::vector<std::string>& names);

/// The names of what `write_group` may write.
std::vector<std::string> group_files(const std::vector<std::string>& names);

/// Landmarks are written of this many points at most: 3D Slicer gets slow with more.
inline constexpr int kMostLandmarks = 2000;

/// Writes, in the coordinates of the files if nothing else is said:
/// - points.npz: `points` (N x P x 3, NaN where a shape lacks a point), `present` (N x P), `names`
///   (N), `template_vertices` (P) and, if there are any, `template_faces` (M x 3);
/// - points.csv: the same in long form, a line a point of a shape: shape, point, x, y, z, present;
/// - meshes/NAME.ply: the faces with the points of a shape. Those that it lacks are where the model
///   has them, and no corners of faces; a shape that lacks all faces has no file;
/// - particles/NAME.particles, for ShapeWorks: a line x y z a point; those that a shape lacks are
///   where the model has them, as all shapes must have all;
/// - landmarks/NAME.mrk.json, for 3D Slicer: what a shape lacks is "missing". Of `kMostLandmarks`
///   points at most;
/// - modes.npz: of the model, in its coordinates, `mean` (P x 3), `modes` (K x P x 3), `variances`
///   (K), `scores` (N x K), `aligned` (N x P x 3), `names`, `template_faces`, and `compactness`,
///   `generalisation`, `specificity` (K);
/// - mean.ply, and modes/mode_K_minus_2sd.ply and modes/mode_K_plus_2sd.ply for the first five
/// modes,
///   from 1: the mean, and what is two standard deviations from it;
/// - scores.csv: of each shape, how many points it has, its scores in standard deviations, and
///   `columns`.
/// Points are numbered from zero. Throws `InvalidInput` if sizes do not fit or by
/// `check_shape_names`, `BadFile` if a file cannot be written.
void write_group(ResultFolder& folder, const GroupOutput& output);

}  // namespace isomatch::results
