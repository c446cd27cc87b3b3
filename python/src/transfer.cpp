// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/carry/transfer.h"

#include <fmt/format.h>
#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <memory>
#include <utility>

#include "arrays.h"
#include "bindings.h"
#include "isomatch/carry/map_inversion.h"
#include "isomatch/carry/pose_transfer.h"
#include "isomatch/carry/texture_transfer.h"
#include "isomatch/error.h"
#include "options.h"
#include "run.h"
#include "shapes.h"
#include "textures.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

using SharedMesh = std::shared_ptr<MatchInput>;

/// Two meshes and where the vertices of each lie on the other.
struct Transfer {
  SharedMesh source, target;
  SurfaceMap source_to_target, target_to_source;
};

/// A map that was given as vertices, or as faces and weights.
SurfaceMap given_map(const MatchInput& from, const MatchInput& onto, const py::tuple& arrays) {
  SurfaceMap points;
  if (arrays.size() == 2) {
    points = to_surface_map(arrays[0].cast<py::array>(), arrays[1].cast<py::array>());
  } else {
    const VertexMap vertices = to_integers(arrays[0].cast<py::array>(), "the map");
    check_map(vertices, from.shape.num_vertices(), onto.shape.num_vertices());
    points = corner_points(onto.mesh(), vertices);
  }
  check_map(points, from.shape.num_vertices(), onto.mesh().num_faces());
  return points;
}

Transfer make_transfer(const SharedMesh& source, const SharedMesh& target,
                       const py::tuple& source_to_target, const py::tuple& target_to_source) {
  return {source, target, given_map(*source, *target, source_to_target),
          given_map(*target, *source, target_to_source)};
}

py::dict inverse(const MatchInput& source, const MatchInput& target,
                 const py::tuple& source_to_target, const py::dict& keywords,
                 const RunOptions& how) {
  const auto options = to_options<InversionOptions>(keywords);
  const SurfaceMap points = given_map(source, target, source_to_target);
  return to_dict(source.mesh(), run(how, [&](const Context& context) {
                   return invert_map(source.mesh(), target.mesh(), points, options, context);
                 }));
}

/// The source's points on the target; of vertices if one array is given.
py::dict landmarks(const Transfer& transfer, const py::tuple& arrays) {
  const Mesh& source = transfer.source->mesh();
  SurfaceMap points;
  if (arrays.size() == 2) {
    points = to_surface_map(arrays[0].cast<py::array>(), arrays[1].cast<py::array>());
  } else {
    const std::vector<int> vertices = to_integers(arrays[0].cast<py::array>(), "landmarks");
    for (const int vertex : vertices)
      if (vertex < 0 || vertex >= source.num_vertices())
        throw InvalidInput(fmt::format("landmarks: vertex {} is out of range; there are {}", vertex,
                                       source.num_vertices()));
    points = corner_points(source, vertices);
  }
  const Mesh& target = transfer.target->mesh();
  return to_dict(target, transfer_points(source, target, transfer.source_to_target, points));
}

/// Those weights of a row a vertex, a column a bone, that are not 0.
SkinWeights influences(const py::array& rows) {
  const Doubles weights = to_doubles(rows, "weights");
  SkinWeights result(static_cast<std::size_t>(weights.shape(0)));
  const double* weight = weights.data();
  for (std::vector<Influence>& vertex : result) {
    for (int bone = 0; bone < weights.shape(1); ++bone, ++weight) {
      if (*weight != 0) vertex.push_back({bone, *weight});
    }
  }
  return result;
}

Eigen::MatrixXd skin(const Transfer& transfer, const py::array& rows) {
  const SkinWeights weights = influences(rows);
  const py::ssize_t bones = rows.shape(1);
  const py::gil_scoped_release release;
  const SkinWeights carried =
      transfer_skin(transfer.source->mesh(), transfer.target_to_source, weights);
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(std::ssize(carried), bones);
  for (std::size_t v = 0; v < carried.size(); ++v) {
    for (const auto& [bone, weight] : carried[v]) result(v, bone) = weight;
  }
  return result;
}

/// Each frame in the target's vertices. The frames are those of one array of coordinates.
std::vector<Point> carried_frames(const Transfer& transfer, const std::vector<Point>& frames,
                                  const PoseTransferOptions& options, const Context& context) {
  const Mesh& source = transfer.source->mesh();
  const PoseTransfer carry(source, transfer.target->mesh(), transfer.target_to_source, options);
  std::vector<Point> result;
  for (std::size_t begin = 0; begin < frames.size(); begin += source.vertices.size()) {
    context.report(static_cast<double>(begin) / static_cast<double>(frames.size()), "poses");
    const std::vector<Point> pose = carry(std::span(frames).subspan(begin, source.vertices.size()));
    result.insert(result.end(), pose.begin(), pose.end());
  }
  return result;
}

py::array_t<double> poses(const Transfer& transfer, const py::array& frames,
                          const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<PoseTransferOptions>(keywords);
  const std::vector<Point> positions = to_points(frames, "frames");
  if (positions.size() % transfer.source->mesh().vertices.size() != 0)
    throw InvalidInput(fmt::format("frames: expected a row for each of {} source vertices",
                                   transfer.source->mesh().num_vertices()));
  return to_array(run(how, [&](const Context& context) {
    return carried_frames(transfer, positions, options, context);
  }));
}

py::dict texture(const Transfer& transfer, const TexturedMesh& textured, const py::dict& keywords) {
  const auto options = to_options<TextureTransferOptions>(keywords);
  const Mesh& source = transfer.source->mesh();
  if (textured.mesh.faces != source.faces)
    throw InvalidInput("the textured mesh does not have the faces of the source");
  TexturedMesh carried;
  {
    const py::gil_scoped_release release;
    carried = transfer_texture(source, textured.texture, transfer.target->mesh(),
                               transfer.target_to_source, options);
  }
  return to_dict(std::move(carried));
}

}  // namespace

void bind_transfer(py::module_& module) {
  register_options<InversionOptions>(module, "inversion");
  register_options<TextureTransferOptions>(module, "texture");
  register_options<PoseTransferOptions>(module, "poses");
  module.def("invert_map", inverse);
  py::class_<Transfer>(module, "Transfer")
      .def(py::init(&make_transfer))
      .def(
          "values",
          [](const Transfer& transfer, const Eigen::MatrixXd& values) {
            return transfer_values(transfer.source->mesh(), transfer.target_to_source, values);
          },
          py::call_guard<py::gil_scoped_release>())
      .def("labels",
           [](const Transfer& transfer, const py::array& labels) {
             return adopt(transfer_labels(transfer.source->mesh(), transfer.target_to_source,
                                          to_integers(labels, "labels")));
           })
      .def("landmarks", landmarks)
      .def("skin", skin)
      .def("poses", poses)
      .def("texture",
           [](const Transfer& transfer, const py::tuple& textured, const py::dict& keywords) {
             return texture(transfer, to_textured(textured), keywords);
           });
}

}  // namespace isomatch::python
