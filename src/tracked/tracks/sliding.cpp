// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/sliding.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/closest_point.h"
#include "geometry/cotangent_laplacian.h"
#include "geometry/hat_gradients.h"
#include "geometry/interpolation.h"
#include "geometry/tangent_frame.h"
#include "geometry/walk.h"

namespace isomatch::tracked {
namespace {

/// Tangent vectors, in coordinates of a frame.
using Tangent = Eigen::Vector2d;
using Matrix2 = Eigen::Matrix2d;

/// Of unit length, whatever happens where faces have no area.
Point direction_of(const Point& normal) {
  return normal.isZero() ? Point::UnitZ() : normal.stableNormalized();
}

TangentFrame turned(const TangentFrame& frame, double cosine, double sine) {
  return {cosine * frame.first + sine * frame.second, cosine * frame.second - sine * frame.first};
}

/// An edge as one of its ends sees it: the other end, its weight, and how that end's tangent
/// vectors turn on their way here.
struct Link {
  int to;
  double weight;
  Matrix2 turn;
};

/// What forms differ by at one vertex.
struct Difference {
  Eigen::Vector3d value;
  /// By the coordinates of the tangent vector that the image moves along.
  Eigen::Matrix<double, 3, 2> slope;
};

/// Such that the square of their length counts the mean curvature and its deviator.
Eigen::Vector3d components(const PlaneForm& form) {
  return {(form.first + form.second) / 2, (form.first - form.second) / 2, form.mixed};
}

/// What a vertex wants: half the Hessian and the negative gradient of its part of the energy.
struct Pull {
  Matrix2 stiffness = Matrix2::Zero();
  Tangent force = Tangent::Zero();
};

class Sliding {
 public:
  Sliding(const Proxy& source, const Proxy& target, const std::vector<bool>& inside,
          const SlidingOptions& options)
      : source_(source),
        target_(target),
        inside_(inside),
        options_(options),
        areas_(vertex_areas(source.mesh)),
        target_forms_(second_forms_of(target, options.curvature_length)) {
    for (const Point& normal : source.normals) {
      normals_.push_back(direction_of(normal));
      frames_.push_back(tangent_frame(normals_.back()));
    }
    link();
    measure_forms();
  }

  void step(SurfaceMap& images) const {
    const std::vector<TangentFrame> frames = frames_below(images);
    std::vector<Pull> pulls;
    for (std::size_t v = 0; v < images.size(); ++v)
      pulls.push_back(pull(static_cast<int>(v), images[v], frames[v]));
    const std::vector<Tangent> moves = smooth_moves(pulls);
    for (std::size_t v = 0; v < images.size(); ++v) move(images[v], frames[v], moves[v]);
  }

 private:
  /// Connects the ends of all edges with cotangent weights.
  void link() {
    const Mesh& mesh = source_.mesh;
    const Eigen::SparseMatrix<double, Eigen::RowMajor> laplacian = cotangent_laplacian(mesh);
    constexpr double kLeast = 1e-3;  // So that no vertex is on its own.
    links_.resize(mesh.vertices.size());
    for (int v = 0; v < mesh.num_vertices(); ++v) {
      for (decltype(laplacian)::InnerIterator entry(laplacian, v); entry; ++entry) {
        const int w = static_cast<int>(entry.col());
        if (w != v) links_[v].push_back({w, std::max(kLeast, -entry.value()), transport(w, v)});
      }
    }
  }

  /// Tangent vectors of one vertex at another, by the shortest rotation between the normals.
  Matrix2 transport(int from, int to) const {
    const auto rotation = Eigen::Quaterniond::FromTwoVectors(normals_[from], normals_[to]);
    Matrix2 turn;
    turn.col(0) = frames_[to].coordinates(rotation * frames_[from].first);
    turn.col(1) = frames_[to].coordinates(rotation * frames_[from].second);
    return turn;
  }

  /// Forms of the source, and what makes those of all scales count the same.
  void measure_forms() {
    const auto forms = second_forms_of(source_, options_.curvature_length);
    for (int v = 0; v < source_.num_vertices(); ++v)
      for (const SymmetricTensor& form : (*forms)[v])
        forms_.push_back(components(in_plane(form, frames_[v].first, frames_[v].second)));
    for (int k = 0; k < kSecondFormScales; ++k) {
      double area = 0, mean = 0, mean_square = 0, other_square = 0;
      for (int v = 0; v < source_.num_vertices(); ++v) {
        const Eigen::Vector3d& form = this->form(v, k);
        area += areas_[v];
        mean += areas_[v] * form[0];
        mean_square += areas_[v] * form[0] * form[0];
        other_square += areas_[v] * (form[1] * form[1] + form[2] * form[2]);
      }
      mean /= area;
      const auto weight = [](double square) { return 1 / std::sqrt(std::max(square, 1e-12)); };
      const double other = weight(other_square / area);
      weights_[k] = {weight(mean_square / area - mean * mean), other, other};
    }
  }

  const Eigen::Vector3d& form(int v, int k) const { return forms_[v * kSecondFormScales + k]; }

  /// The frames of the source as the map turns them.
  std::vector<TangentFrame> frames_below(const SurfaceMap& images) const {
    std::vector<Point> places;
    for (const SurfacePoint& image : images) places.push_back(position(target_.mesh, image));
    std::vector<Eigen::Matrix3d> stretch;
    const std::vector<Point>& rest = source_.mesh.vertices;
    for (int v = 0; v < source_.num_vertices(); ++v) {
      stretch.push_back(Eigen::Matrix3d::Zero());
      for (const Link& link : links_[v])
        stretch.back() +=
            link.weight * (places[link.to] - places[v]) * (rest[link.to] - rest[v]).transpose();
    }
    std::vector<TangentFrame> frames;
    for (int v = 0; v < source_.num_vertices(); ++v) {
      Eigen::Matrix3d around = stretch[v];
      for (const Link& link : links_[v]) around += stretch[link.to];
      const TangentFrame there =
          tangent_frame(direction_of(interpolated(target_.mesh, target_.normals, images[v])));
      const Tangent first = there.coordinates(around * frames_[v].first),
                    second = there.coordinates(around * frames_[v].second);
      const double cosine = first.x() + second.y(), sine = first.y() - second.x();
      const double length = std::hypot(cosine, sine);
      frames.push_back(length > 0 ? turned(there, cosine / length, sine / length) : there);
    }
    return frames;
  }

  Pull pull(int v, const SurfacePoint& image, const TangentFrame& frame) const {
    Pull result;
    if (!inside_.empty() && !inside_[v]) return result;
    const Face& face = target_.mesh.faces[image.face];
    const std::array<Point, 3> gradients = hat_gradients(target_.mesh, face);
    const double area = area_vector(target_.mesh, face).norm() / 2;
    if (area <= 0) return result;
    for (int k = 0; k < kSecondFormScales; ++k) {
      Difference difference{-form(v, k), Eigen::Matrix<double, 3, 2>::Zero()};
      for (int corner = 0; corner < 3; ++corner) {
        const Eigen::Vector3d there =
            components(in_plane((*target_forms_)[face[corner]][k], frame.first, frame.second));
        difference.value += image.weights[corner] * there;
        difference.slope += there * frame.coordinates(gradients[corner] / area).transpose();
      }
      difference.value.array() *= weights_[k].array();
      difference.slope.array().colwise() *= weights_[k].array();
      // Geman and McClure's weight: where surfaces differ anyway, they tell nothing.
      const double doubt = 1 + difference.value.squaredNorm();
      const double weight = areas_[v] / (kSecondFormScales * doubt * doubt);
      result.stiffness += weight * difference.slope.transpose() * difference.slope;
      result.force -= weight * difference.slope.transpose() * difference.value;
    }
    return result;
  }

  /// The moves that balance the pulls and being smooth, by conjugate gradients.
  std::vector<Tangent> smooth_moves(const std::vector<Pull>& pulls) const {
    constexpr int kMost = 60;
    constexpr double kTolerance = 1e-3;
    const std::vector<Matrix2> inverse = inverse_diagonal(pulls);
    std::vector<Tangent> moves(pulls.size(), Tangent::Zero()), direction = moves, residual;
    for (const Pull& pull : pulls) residual.push_back(pull.force);
    double first = 0, old = 0;
    for (int iteration = 0; iteration < kMost; ++iteration) {
      double product = 0;
      for (std::size_t v = 0; v < moves.size(); ++v)
        product += residual[v].dot(inverse[v] * residual[v]);
      if (iteration == 0) first = product;
      if (product <= kTolerance * kTolerance * first) break;
      const double share = iteration == 0 ? 0 : product / old;
      old = product;
      for (std::size_t v = 0; v < moves.size(); ++v)
        direction[v] = inverse[v] * residual[v] + share * direction[v];
      const std::vector<Tangent> image = resistance(pulls, direction);
      double curvature = 0;
      for (std::size_t v = 0; v < moves.size(); ++v) curvature += image[v].dot(direction[v]);
      for (std::size_t v = 0; v < moves.size(); ++v) {
        moves[v] += product / curvature * direction[v];
        residual[v] -= product / curvature * image[v];
      }
    }
    return moves;
  }

  /// Of the system that is solved, the inverse of what each vertex has to do with itself.
  std::vector<Matrix2> inverse_diagonal(const std::vector<Pull>& pulls) const {
    std::vector<Matrix2> inverse;
    for (std::size_t v = 0; v < pulls.size(); ++v) {
      double weight = 0;
      for (const Link& link : links_[v]) weight += link.weight;
      inverse.push_back(
          (pulls[v].stiffness + options_.stiffness * weight * Matrix2::Identity()).inverse());
    }
    return inverse;
  }

  /// What pulls and links do against moves.
  std::vector<Tangent> resistance(const std::vector<Pull>& pulls,
                                  const std::vector<Tangent>& moves) const {
    std::vector<Tangent> forces;
    for (std::size_t v = 0; v < moves.size(); ++v) {
      forces.push_back(pulls[v].stiffness * moves[v]);
      for (const Link& link : links_[v])
        forces.back() += options_.stiffness * link.weight * (moves[v] - link.turn * moves[link.to]);
    }
    return forces;
  }

  void move(SurfacePoint& image, const TangentFrame& frame, const Tangent& move) const {
    const double length = move.norm();
    if (length == 0) return;
    const Point p = position(target_.mesh, image) +
                    frame.vector(move * std::min(1.0, options_.longest / length));
    const int vertex =
        walk_to_vertex(target_.mesh, target_.faces, heaviest_corner(target_.mesh, image), p);
    image = closest_point_around(target_.mesh, target_.faces, vertex, p);
  }

  const Proxy& source_;
  const Proxy& target_;
  const std::vector<bool>& inside_;
  const SlidingOptions& options_;
  std::vector<double> areas_;
  std::shared_ptr<const std::vector<SecondForm>> target_forms_;
  std::vector<Point> normals_;
  std::vector<TangentFrame> frames_;
  std::vector<std::vector<Link>> links_;
  std::vector<Eigen::Vector3d> forms_;
  std::array<Eigen::Vector3d, kSecondFormScales> weights_;
};

}  // namespace

SurfaceMap slid(const Proxy& source, const Proxy& target, SurfaceMap images,
                const std::vector<bool>& inside, const SlidingOptions& options) {
  const Sliding sliding(source, target, inside, options);
  for (int step = 0; step < options.steps; ++step) sliding.step(images);
  return images;
}

}  // namespace isomatch::tracked
