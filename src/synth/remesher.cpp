// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "synth/remesher.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <tuple>

#include "parallel.h"

namespace isomatch::synth {
namespace {

Vector cross(const Point& a, const Point& b, const Point& c) { return (b - a).cross(c - a); }

/// Cotangent of the angle at `apex` in a triangle.
double cotangent(const Point& apex, const Point& a, const Point& b) {
  const double sine = (a - apex).cross(b - apex).norm();
  return (a - apex).dot(b - apex) / std::max(sine, 1e-300);
}

/// 1 for an equilateral triangle, 0 for a degenerate one.
double quality(const Point& a, const Point& b, const Point& c) {
  const double sides = (a - b).squaredNorm() + (b - c).squaredNorm() + (c - a).squaredNorm();
  return 2 * std::sqrt(3.0) * cross(a, b, c).norm() / std::max(sides, 1e-300);
}

}  // namespace

Remesher::Remesher(const Body& body, const Pose& pose, const Mesh& mesh, const Context& context)
    : body_(&body),
      pose_(&pose),
      context_(&context),
      table_(mesh),
      rest_(mesh.vertices),
      posed_(mesh.vertices.size()) {
  parallel_for(std::ssize(rest_), context, [&](std::ptrdiff_t v) { posed_[v] = pose(rest_[v]); });
}

double Remesher::area() const {
  double sum = 0;
  for (int c = 0; c < table_.num_corners(); c += 3) {
    if (!table_.is_live(c)) continue;
    sum +=
        cross(posed_[table_.vertex(c)], posed_[table_.vertex(c + 1)], posed_[table_.vertex(c + 2)])
            .norm() /
        2;
  }
  return sum;
}

double Remesher::squared_length(int corner) const {
  return (posed_[table_.from(corner)] - posed_[table_.to(corner)]).squaredNorm();
}

void Remesher::split_above(double length) {
  const int corners = table_.num_corners();
  for (int c = 0; c < corners; ++c) {
    if (!table_.is_live(c) || table_.opposite(c) < c || squared_length(c) <= length * length)
      continue;
    const Point middle = body_->project((rest_[table_.from(c)] + rest_[table_.to(c)]) / 2);
    table_.split(c);
    rest_.push_back(middle);
    posed_.push_back((*pose_)(middle));
  }
}

bool Remesher::fits(int vertex, int other, const Point& target, const Vector& normal) const {
  bool fits = true;
  table_.around(vertex, [&](int c) {
    const int a = table_.from(c), b = table_.to(c);
    if (a == other || b == other) return;
    const Vector n = cross(target, rest_[a], rest_[b]);
    fits &= n.dot(normal) > 0.1 * n.norm();
  });
  return fits;
}

std::optional<Point> Remesher::collapse_target(int corner) const {
  if (!table_.can_collapse(corner)) return {};
  const int u = table_.from(corner), v = table_.to(corner);
  const Point target = body_->project((rest_[u] + rest_[v]) / 2);
  const Vector normal = body_->normal(target);
  if (!fits(u, v, target, normal) || !fits(v, u, target, normal)) return {};
  return target;
}

void Remesher::collapse_to(int vertices) {
  const auto later = [](const Edge& a, const Edge& b) {
    return std::tie(a.length, a.corner) > std::tie(b.length, b.corner);
  };
  std::priority_queue<Edge, std::vector<Edge>, decltype(later)> queue(later);
  const auto push = [&](int c) {
    queue.push({squared_length(c), c, table_.from(c), table_.to(c)});
  };
  for (int c = 0; c < table_.num_corners(); ++c)
    if (table_.is_live(c) && table_.opposite(c) > c) push(c);
  while (num_vertices() > vertices && !queue.empty()) {
    const auto [length, c, from, to] = queue.top();
    queue.pop();
    const bool current = table_.is_live(c) && table_.from(c) == from && table_.to(c) == to &&
                         squared_length(c) == length;
    if (!current) continue;
    const std::optional<Point> target = collapse_target(c);
    if (!target) continue;
    table_.collapse(c);
    rest_[from] = *target;
    posed_[from] = (*pose_)(*target);
    table_.around(from, [&](int at) { push(CornerTable::next(at)); });
  }
  compact();
}

void Remesher::compact() {
  const std::vector<int> kept = table_.compact();
  for (std::size_t v = 0; v < kept.size(); ++v) {
    rest_[v] = rest_[kept[v]];
    posed_[v] = posed_[kept[v]];
  }
  rest_.resize(kept.size());
  posed_.resize(kept.size());
}

bool Remesher::flip_improves(int corner) const {
  const Point &a = posed_[table_.vertex(corner)],
              &b = posed_[table_.vertex(table_.opposite(corner))];
  const Point &u = posed_[table_.from(corner)], &v = posed_[table_.to(corner)];
  // The margin keeps rounding from flipping back and forth.
  if (cotangent(a, u, v) + cotangent(b, u, v) >= -1e-6) return false;
  const Vector normal = (cross(a, u, v) + cross(b, v, u)).normalized();
  const Vector left = cross(a, u, b), right = cross(b, v, a);
  return left.dot(normal) > 0.5 * left.norm() && right.dot(normal) > 0.5 * right.norm();
}

void Remesher::flip() {
  constexpr int kMaxPasses = 10;
  bool changed = true;
  for (int pass = 0; changed && pass < kMaxPasses; ++pass) {
    changed = false;
    for (int c = 0; c < table_.num_corners(); ++c)
      if (table_.opposite(c) > c && flip_improves(c)) changed |= table_.flip(c);
  }
}

Point Remesher::relaxed(int vertex) const {
  Point sum = Point::Zero();
  double total = 0;
  table_.around(vertex, [&](int c) {
    const int a = table_.from(c), b = table_.to(c);
    const double area = cross(posed_[vertex], posed_[a], posed_[b]).norm();
    sum += area / 3 * (rest_[vertex] + rest_[a] + rest_[b]);
    total += area;
  });
  if (total == 0) return rest_[vertex];
  const Point target = body_->project(sum / total);
  constexpr double kGood = 0.5;
  return star_quality(vertex, target) >= std::min(kGood, star_quality(vertex, rest_[vertex]))
             ? target
             : rest_[vertex];
}

double Remesher::star_quality(int vertex, const Point& p) const {
  double least = 1;
  table_.around(vertex, [&](int c) {
    least = std::min(least, quality(p, rest_[table_.from(c)], rest_[table_.to(c)]));
  });
  return least;
}

void Remesher::relax() {
  std::vector<Point> rest(rest_.size());
  parallel_for(num_vertices(), *context_,
               [&](std::ptrdiff_t v) { rest[v] = relaxed(static_cast<int>(v)); });
  rest_ = std::move(rest);
  parallel_for(num_vertices(), *context_,
               [&](std::ptrdiff_t v) { posed_[v] = (*pose_)(rest_[v]); });
}

void Remesher::subdivide() {
  const int old = num_vertices();
  const auto ends = table_.subdivide();
  rest_.resize(num_vertices());
  posed_.resize(num_vertices());
  parallel_for(std::ssize(ends), *context_, [&](std::ptrdiff_t i) {
    rest_[old + i] = body_->project((rest_[ends[i][0]] + rest_[ends[i][1]]) / 2);
    posed_[old + i] = (*pose_)(rest_[old + i]);
  });
}

Skin Remesher::take() { return {table_.faces(), std::move(posed_), std::move(rest_)}; }

}  // namespace isomatch::synth
