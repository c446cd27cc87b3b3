// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/shape/shape.h"

#include <utility>

#include "shape/numbers.h"
#include "shape/prepared_shape.h"

namespace isomatch {

Shape::Shape(Mesh mesh, const GeodesicOptions& geodesics)
    : prepared_(std::make_shared<const PreparedShape>(std::move(mesh), geodesics)) {}

const Mesh& Shape::mesh() const { return prepared_->mesh(); }

const MeshDiagnosis& Shape::diagnosis() const { return prepared_->diagnosis(); }

double Shape::area() const { return prepared_->surface()->area; }

int Shape::num_surface_vertices() const { return prepared_->surface()->num_vertices(); }

bool Shape::on_surface(int vertex) const {
  return surface_vertex(*prepared_->surface(), vertex) != kNoVertex;
}

std::span<const int> Shape::copies(int vertex) const {
  const Surface& surface = *prepared_->surface();
  const int place = surface_vertex(surface, vertex);
  return place == kNoVertex ? std::span<const int>() : surface.input_vertices[place];
}

double Shape::max_geodesic(const Context& context) const {
  return prepared_->surface()->scale * prepared_->metric(context).max_geodesic();
}

std::uint64_t kept_bytes(int num_vertices) {
  // Simplified copies and what is computed on them; then meshes, topology and a geodesic graph.
  constexpr std::uint64_t kCopies = 25'000'000, kVertex = 900;
  return kCopies + kVertex * static_cast<std::uint64_t>(num_vertices);
}

}  // namespace isomatch
