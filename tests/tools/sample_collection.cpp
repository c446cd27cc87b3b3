// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tools/sample_collection.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "isomatch/mesh/synth.h"

namespace isomatch::results {
namespace {

/// Numbers about 0, the same with every standard library.
class Numbers {
 public:
  double operator()() {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(engine_()) / std::mt19937::max();
    return sum;
  }

 private:
  std::mt19937 engine_{7};
};

struct Deformation {
  double bend, twist, thickness, neck, legs;
};

Point deformed(const Point& p, const Deformation& d) {
  const double along = p.z();
  Point q = p;
  q.x() *= 1 + d.thickness * std::exp(-along * along);
  q.y() += d.neck * std::max(0.0, along - 0.4) * std::abs(along - 0.4);
  q.y() -= d.legs * std::max(0.0, -p.y()) * std::abs(p.y());
  q = Eigen::AngleAxisd(d.twist * along, Point::UnitZ()) * q;
  return Eigen::AngleAxisd(d.bend * along, Point::UnitY()) * q;
}

GroupPageMember member(const Mesh& mesh, int number, Numbers& random) {
  const double bend = 0.35 * random(), twist = 0.2 * random(), thickness = 0.25 * random();
  const Deformation deformation{bend, twist, thickness, 0.25 * random(), 0.2 * random()};
  GroupPageMember shape;
  shape.name = "creature_" + std::to_string(number);
  for (const Point& p : mesh.vertices) {
    shape.points.push_back(deformed(p, deformation));
    shape.spread.push_back(
        static_cast<float>(0.006 * (1.2 + std::sin(3 * p.z() + number) * std::cos(2 * p.y()))));
  }
  shape.cycle_error = 0.008 + 0.002 * std::abs(random());
  return shape;
}

/// Its front is missing.
void cut(GroupPageMember& shape, const Mesh& mesh) {
  shape.name += "_part";
  for (const Point& p : mesh.vertices) shape.present.push_back(p.z() < 0.7);
}

void spoil(GroupPageMember& shape, const Mesh& mesh, FitGrade grade, double size,
           const std::string& reason) {
  shape.grade = grade;
  shape.reasons = {reason};
  shape.cycle_error += size;
  for (std::size_t v = 0; v < shape.spread.size(); ++v)
    if (mesh.vertices[v].z() < -0.3) shape.spread[v] += static_cast<float>(3 * size);
}

std::vector<GroupPair> star_and_neighbours(const std::vector<GroupPageMember>& members,
                                           Numbers& random) {
  std::vector<GroupPair> pairs;
  const auto count = static_cast<int>(members.size());
  const auto add = [&](int source, int target) {
    const double error = (members[source].cycle_error + members[target].cycle_error) / 2;
    const PairUse use = error > 0.06   ? PairUse::kComposed
                        : error > 0.02 ? PairUse::kRunnerUp
                                       : PairUse::kAgrees;
    pairs.push_back({source, target, 0.1 + 0.03 * std::abs(random()), error, use});
  };
  for (int k = 1; k < count; ++k) add(0, k);
  for (int k = 1; k < count; ++k)
    for (int step : {1, 3, 7})
      if (k + step < count) add(k, k + step);
  return pairs;
}

Eigen::MatrixXd centred(const std::vector<GroupPageMember>& members, std::vector<Point>& mean) {
  const auto rows = static_cast<Eigen::Index>(members.size());
  const auto columns = static_cast<Eigen::Index>(3 * members.front().points.size());
  Eigen::MatrixXd points(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i)
    points.row(i) = Eigen::Map<const Eigen::RowVectorXd>(members[i].points.front().data(), columns);
  const Eigen::RowVectorXd middle = points.colwise().mean();
  for (Eigen::Index x = 0; x < columns; x += 3) mean.emplace_back(middle.segment<3>(x).transpose());
  return points.rowwise() - middle;
}

ShapeModel principal_modes(const std::vector<GroupPageMember>& members) {
  ShapeModel model;
  const Eigen::MatrixXd points = centred(members, model.mean);
  const Eigen::Index count = points.rows() - 1;
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver(points * points.transpose());
  const Eigen::MatrixXd vectors = solver.eigenvectors().rowwise().reverse().leftCols(count);
  model.modes = vectors.transpose() * points;
  model.modes.rowwise().normalize();
  model.scores = points * model.modes.transpose();
  model.variances = (model.scores.colwise().squaredNorm() / static_cast<double>(count)).transpose();
  return model;
}

ModelQuality invented_quality(const ShapeModel& model) {
  ModelQuality quality;
  double sum = 0;
  for (Eigen::Index k = 0; k < model.variances.size(); ++k) {
    sum += model.variances[k];
    const auto modes = static_cast<double>(k + 1);
    quality.compactness.push_back(sum / model.variances.sum());
    quality.generalisation.push_back(0.01 + 0.08 / modes);
    quality.specificity.push_back(0.05 * (1 - std::exp(-modes / 3)));
  }
  return quality;
}

}  // namespace

GroupPageData sample_collection(int shapes, int vertices) {
  GroupPageData data;
  data.title = "A made-up collection";
  data.command = {"isomatch", "group", "creatures/*.off", "-o", "out dir", "--report"};
  SynthOptions options;
  options.vertices = vertices;
  options.seed = 2;
  data.template_mesh = synthesize(options).mesh;
  Numbers random;
  for (int k = 0; k < shapes; ++k) data.members.push_back(member(data.template_mesh, k, random));
  data.members.front().points = data.template_mesh.vertices;
  cut(data.members[1], data.template_mesh);
  spoil(data.members[2], data.template_mesh, FitGrade::kPoor, 0.09, "two legs are exchanged");
  for (int k : {3, 4})
    spoil(data.members[k], data.template_mesh, FitGrade::kDoubtful, 0.03,
          "9 % of the shape is not reached");
  data.pairs = star_and_neighbours(data.members, random);
  const ShapeModel model = principal_modes(data.members);
  data.model = GroupPageModel{model, invented_quality(model)};
  return data;
}

}  // namespace isomatch::results
