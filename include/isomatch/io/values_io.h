// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <Eigen/Core>
#include <string>
#include <vector>

#include "isomatch/carry/transfer.h"

/// Text files of what belongs to the vertices of a mesh: a line a vertex, in order. Blank lines are
/// passed over. Readers throw `BadFile` that names the line if the file is missing, malformed, or
/// not of `num_vertices` lines; what is written appears whole or not at all and survives a round
/// trip.
namespace isomatch {

/// As many numbers on each line; `nan` is one of them, and means that there is none. Columns are
/// separated by blanks, tabs, commas or semicolons, one kind in a file; a first line of names is
/// passed over. Written with commas into a .csv file, otherwise with blanks.
Eigen::MatrixXd read_values(const std::string& path, int num_vertices);
void write_values(const std::string& path, const Eigen::MatrixXd& values);

/// Integers from 0, or `kNoLabel`. A first line with a name is passed over.
std::vector<int> read_labels(const std::string& path, int num_vertices);
void write_labels(const std::string& path, const std::vector<int>& labels);

/// Words BONE:WEIGHT, bones being integers from 0; a line of `-` has none.
SkinWeights read_skin_weights(const std::string& path, int num_vertices);
void write_skin_weights(const std::string& path, const SkinWeights& weights);

}  // namespace isomatch
