// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/contour.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "parallel.h"

namespace isomatch::synth {
namespace {

/// The cube's six tetrahedra, positively oriented. Corner bits: 1 is x, 2 is y, 4 is z.
constexpr std::array<std::array<int, 4>, 6> kTetrahedra = {
    {{0, 1, 3, 7}, {0, 2, 6, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}, {0, 3, 2, 7}, {0, 6, 4, 7}}};

/// An edge goes from a lattice point in one of seven directions, given by corner bits.
constexpr int kDirections = 7;

/// A bound on the gradient of a body's implicit function: squeezed tubes and steep tapers add to 1.
constexpr double kSteepest = 1.5;

Eigen::Quaterniond random_turn(Random& random) {
  const double u = random.uniform(), a = 2 * std::numbers::pi * random.uniform(),
               b = 2 * std::numbers::pi * random.uniform();
  const double s = std::sqrt(1 - u), t = std::sqrt(u);
  return {t * std::cos(b), s * std::sin(a), s * std::cos(a), t * std::sin(b)};
}

void extend(Eigen::AlignedBox3d& box, const Eigen::Quaterniond& turn, const Limb& limb) {
  for (const Tube& tube : limb.tubes) {
    const double reach =
        *std::max_element(tube.radii.begin(), tube.radii.end()) * std::max(tube.width, 1.0);
    for (double end : {0.0, tube.length}) {
      for (const Point& p : {tube.at(end), mirrored(tube.at(end))}) {
        box.extend(turn.inverse() * p - Vector::Constant(reach));
        box.extend(turn.inverse() * p + Vector::Constant(reach));
      }
    }
  }
}

/// A box in the turned frame that holds the body; blending adds less than the margin.
Eigen::AlignedBox3d bounds(const Body& body, const Eigen::Quaterniond& turn) {
  Eigen::AlignedBox3d box;
  Limb trunk;
  trunk.tubes = {body.trunk};
  trunk.blend = 0;
  extend(box, turn, trunk);
  double margin = 0;
  for (const Limb& limb : body.limbs) {
    extend(box, turn, limb);
    margin = std::max(margin, limb.blend / 3);
  }
  box.extend(box.min() - Vector::Constant(margin));
  box.extend(box.max() + Vector::Constant(margin));
  return box;
}

class Lattice {
 public:
  Lattice(const Body& body, double spacing, Random& random, const Context& context)
      : turn_(random_turn(random)), spacing_(spacing) {
    const Eigen::AlignedBox3d box = bounds(body, turn_);
    origin_ = box.min();
    for (int i = 0; i < 3; ++i) {
      origin_[i] -= spacing * random.uniform();
      size_[i] = static_cast<int>(std::ceil((box.max()[i] - origin_[i]) / spacing)) + 1;
    }
    evaluate(body, context);
  }

  Mesh march() {
    edge_vertex_.assign(values_.size() * kDirections, -1);
    for (int z = 0; z + 1 < size_[2]; ++z)
      for (int y = 0; y + 1 < size_[1]; ++y)
        for (int x = 0; x + 1 < size_[0]; ++x) march_cube(index(x, y, z));
    return std::move(mesh_);
  }

 private:
  std::size_t index(int x, int y, int z) const {
    return x + static_cast<std::size_t>(size_[0]) * (y + static_cast<std::size_t>(size_[1]) * z);
  }

  std::size_t corner(std::size_t cube, int bits) const {
    return cube + index(bits & 1, (bits >> 1) & 1, bits >> 2);
  }

  Point position(std::size_t i) const {
    const std::size_t row = i / size_[0], x = i % size_[0], y = row % size_[1], z = row / size_[1];
    const Eigen::Matrix<std::size_t, 3, 1> cell(x, y, z);
    return turn_ * (origin_ + spacing_ * cell.cast<double>());
  }

  void evaluate(const Body& body, const Context& context) {
    values_.resize(index(0, 0, size_[2]));
    const int rows = size_[1] * size_[2];
    parallel_for(rows, context,
                 [&](std::ptrdiff_t row) { evaluate_row(body, static_cast<int>(row)); });
  }

  /// Passes over points that are too far from the skin for any of their edges to cross it. They get
  /// a value of the right sign.
  void evaluate_row(const Body& body, int row) {
    const std::size_t first = static_cast<std::size_t>(row) * size_[0];
    for (int x = 0; x < size_[0];) {
      const double value = body.sample(position(first + x)).value;
      const double free = std::abs(value) / (kSteepest * spacing_) - std::numbers::sqrt3;
      const int end = std::min(size_[0], x + 1 + std::max(0, static_cast<int>(free)));
      std::fill(&values_[first + x], &values_[first + end - 1] + 1, value);
      x = end;
    }
  }

  void march_cube(std::size_t cube) {
    int inside = 0;
    for (int bits = 0; bits < 8; ++bits) inside += values_[corner(cube, bits)] < 0;
    if (inside == 0 || inside == 8) return;
    for (const auto& tetrahedron : kTetrahedra) march_tetrahedron(cube, tetrahedron);
  }

  void march_tetrahedron(std::size_t cube, std::array<int, 4> corners) {
    // Inside corners go first, the rest keeps the tetrahedron positively oriented.
    std::array<int, 4> order = {0, 1, 2, 3};
    std::array<bool, 4> is_inside;
    int inside = 0, swaps = 0;
    for (int i = 0; i < 4; ++i) {
      is_inside[i] = values_[corner(cube, corners[i])] < 0;
      if (!is_inside[i]) continue;
      for (int j = i; j > inside; --j, ++swaps) std::swap(order[j], order[j - 1]);
      ++inside;
    }
    if (inside == 0 || inside == 4) return;
    if (swaps % 2 == 1) inside == 3 ? std::swap(order[0], order[1]) : std::swap(order[2], order[3]);
    const auto cut = [&](int i, int j) {
      return cut_vertex(cube, corners[order[i]], corners[order[j]]);
    };
    if (inside == 1) mesh_.faces.push_back({cut(0, 1), cut(0, 2), cut(0, 3)});
    if (inside == 3) mesh_.faces.push_back({cut(3, 0), cut(3, 1), cut(3, 2)});
    if (inside == 2) {
      mesh_.faces.push_back({cut(0, 2), cut(0, 3), cut(1, 3)});
      mesh_.faces.push_back({cut(0, 2), cut(1, 3), cut(1, 2)});
    }
  }

  int cut_vertex(std::size_t cube, int a, int b) {
    const auto [low, high] = std::minmax(a, b);
    const std::size_t from = corner(cube, low), to = corner(cube, high);
    int& vertex = edge_vertex_[from * kDirections + (high - low) - 1];
    if (vertex < 0) {
      vertex = mesh_.num_vertices();
      const double t = values_[from] / (values_[from] - values_[to]);
      mesh_.vertices.push_back((1 - t) * position(from) + t * position(to));
    }
    return vertex;
  }

  Eigen::Quaterniond turn_;
  double spacing_;
  Point origin_;
  std::array<int, 3> size_;
  std::vector<double> values_;
  std::vector<int> edge_vertex_;
  Mesh mesh_;
};

}  // namespace

Mesh contour(const Body& body, double spacing, Random& random, const Context& context) {
  Mesh mesh = Lattice(body, spacing, random, context).march();
  parallel_for(mesh.num_vertices(), context,
               [&](std::ptrdiff_t v) { mesh.vertices[v] = body.project(mesh.vertices[v]); });
  return mesh;
}

}  // namespace isomatch::synth
