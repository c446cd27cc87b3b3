// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "transfer/carry.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "isomatch/carry/pose_transfer.h"
#include "isomatch/carry/transfer.h"
#include "isomatch/error.h"
#include "isomatch/io/map_file.h"
#include "isomatch/io/mesh_io.h"
#include "isomatch/io/model_io.h"
#include "isomatch/io/values_io.h"
#include "isomatch/version.h"
#include "load.h"
#include "results/files/written_files.h"
#include "transfer/outputs.h"

namespace isomatch::cli {
namespace {

namespace fs = std::filesystem;

/// What colours and textures leave uncovered, to be seen as such.
const Eigen::Vector3d kUnknownColor(0.5, 0.5, 0.5);

void check_same_mesh(const std::string& path, const Mesh& mesh, const Mesh& from) {
  if (mesh.faces != from.faces || mesh.num_vertices() != from.num_vertices())
    throw BadFile(path, "does not have the vertices and faces of the mesh that was matched");
}

void create_folder(const std::string& path) {
  std::error_code error;
  fs::create_directories(path, error);
  if (error) throw BadFile(path, "cannot be created: " + error.message());
}

/// Creates the folder of frames with the list by which isomatch will know them again.
void prepare_frames(const TransferArguments& arguments) {
  create_folder(arguments.output);
  std::vector<std::string> files =
      results::written_files(arguments.output, results::Listing::kOfTransfer);
  for (const std::string& frame : arguments.poses)
    if (std::ranges::count(files, frame_name(frame)) == 0) files.push_back(frame_name(frame));
  std::ranges::sort(files);
  results::Json report{{"isomatch", kVersion}};
  results::set_path(report, "result", arguments.folder);
  results::write_listing(arguments.output, results::kTransfer, report, files);
}

}  // namespace

void carry_values(const TransferJob& job, const TransferArguments& arguments) {
  const Eigen::MatrixXd values = read_values(arguments.values, job.from.num_vertices());
  write_values(arguments.output, transfer_values(job.from, job.onto_to_from, values));
}

void carry_labels(const TransferJob& job, const TransferArguments& arguments) {
  const std::vector<int> labels = read_labels(arguments.labels, job.from.num_vertices());
  write_labels(arguments.output, transfer_labels(job.from, job.onto_to_from, labels));
}

void carry_colors(const TransferJob& job, const TransferArguments& arguments) {
  const VertexColors colors = load_vertex_colors(arguments.colors);
  if (std::cmp_not_equal(colors.size(), job.from.num_vertices()))
    throw BadFile(arguments.colors, fmt::format("has {} vertices, but the mesh that was matched {}",
                                                colors.size(), job.from.num_vertices()));
  Eigen::MatrixXd rows(colors.size(), 3);
  for (std::size_t v = 0; v < colors.size(); ++v) rows.row(v) = colors[v].transpose();
  const Eigen::MatrixXd carried = transfer_values(job.from, job.onto_to_from, rows);
  VertexColors result;
  for (Eigen::Index v = 0; v < carried.rows(); ++v)
    result.push_back(carried.row(v).allFinite() ? Eigen::Vector3d(carried.row(v)) : kUnknownColor);
  write_model(arguments.output, {.mesh = job.onto, .colors = std::move(result)});
}

void carry_landmarks(const TransferJob& job, const TransferArguments& arguments) {
  const std::vector<int> landmarks = read_vertex_list(arguments.landmarks, job.from.num_vertices());
  const SurfaceMap points =
      transfer_points(job.from, job.onto, job.from_to_onto, corner_points(job.from, landmarks));
  write_map(arguments.output, {nearest_vertices(job.onto, points), points});
}

void carry_skin(const TransferJob& job, const TransferArguments& arguments) {
  const SkinWeights weights = read_skin_weights(arguments.skin, job.from.num_vertices());
  write_skin_weights(arguments.output, transfer_skin(job.from, job.onto_to_from, weights));
}

void carry_poses(const TransferJob& job, const TransferArguments& arguments) {
  const PoseTransfer carry(job.from, job.onto, job.onto_to_from,
                           {.same_rest_pose = arguments.same_rest_pose});
  Mesh pose = job.onto;
  for (const std::string& path : arguments.poses) {
    const Mesh frame = load_mesh(path);
    check_same_mesh(path, frame, job.from);
    pose.vertices = carry(frame.vertices);
    prepare_frames(arguments);
    write_mesh((fs::path(arguments.output) / frame_name(path)).string(), pose);
  }
}

}  // namespace isomatch::cli
