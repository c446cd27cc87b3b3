// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "tracked/tracks/sliding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "geometry/closest_point.h"
#include "geometry/hat_gradients.h"
#include "geometry/interpolation.h"
#include "geometry/tangent_frame.h"
#include "geometry/walk.h"
#include "tracked/tracks/tangent_field.h"

namespace isomatch::tracked {
namespace {

/// Of unit length, whatever happens where faces have no area.
Point direction_of(const Point& normal) {
  return normal.isZero() ? Point::UnitZ() : normal.stableNormalized();
}

std::vector<Point> directions_of(std::vector<Point> normals) {
  for (Point& normal : normals) normal = direction_of(normal);
  return normals;
}

TangentFrame turned(const TangentFrame& frame, double cosine, double sine) {
  return {cosine * frame.first + sine * frame.second, cosine * frame.second - sine * frame.first};
}

/// What forms differ by at one vertex.
struct Difference {
  Eigen::Vector3d value;
  /// By the coordinates of the tangent vector that the image moves along.
  Eigen::Matrix<double, 3, 2> slope;
};

/// Such that the square of their length counts the mean curvature and its deviator.
Eigen::Vector3d components_in(const TangentFrame& frame, const SymmetricTensor& tensor) {
  const PlaneForm form = in_plane(tensor, frame.first, frame.second);
  return {(form.first + form.second) / 2, (form.first - form.second) / 2, form.mixed};
}

class Sliding {
 public:
  Sliding(const Proxy& source, const Proxy& target, const std::vector<bool>& inside,
          const SlidingOptions& options)
      : source_(source),
        target_(target),
        inside_(inside),
        options_(options),
        areas_(vertex_areas(source.mesh)),
        connection_(source.mesh, directions_of(source.normals)),
        target_forms_(second_forms_of(target, options.curvature_length)) {
    measure_forms();
    for (int k = 0; k < kSecondFormScales; ++k) weights_[k] = weights_of_scale(k);
  }

  void step(SurfaceMap& images) const {
    const std::vector<TangentFrame> frames = frames_below(images);
    std::vector<Pull> pulls;
    for (std::size_t v = 0; v < images.size(); ++v)
      pulls.push_back(pull(static_cast<int>(v), images[v], frames[v]));
    const TangentField moves = connection_.balanced(pulls, options_.stiffness);
    for (std::size_t v = 0; v < images.size(); ++v) move(images[v], frames[v], moves[v]);
  }

 private:
  void measure_forms() {
    const auto forms = second_forms_of(source_, options_.curvature_length);
    for (int v = 0; v < source_.num_vertices(); ++v)
      for (const SymmetricTensor& form : (*forms)[v])
        forms_.push_back(components_in(connection_.frame(v), form));
  }

  /// What makes the forms of all scales count the same.
  Eigen::Vector3d weights_of_scale(int k) const {
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
    return {weight(mean_square / area - mean * mean), other, other};
  }

  const Eigen::Vector3d& form(int v, int k) const { return forms_[v * kSecondFormScales + k]; }

  /// The frames of the source as the map turns them.
  std::vector<TangentFrame> frames_below(const SurfaceMap& images) const {
    const std::vector<Eigen::Matrix3d> stretches = this->stretches(images);
    std::vector<TangentFrame> frames;
    for (int v = 0; v < source_.num_vertices(); ++v) {
      Eigen::Matrix3d around = stretches[v];
      for (const Connection::Link& link : connection_.links(v)) around += stretches[link.to];
      const TangentFrame& here = connection_.frame(v);
      const TangentFrame there =
          tangent_frame(direction_of(interpolated(target_.mesh, target_.normals, images[v])));
      const Tangent first = there.coordinates(around * here.first),
                    second = there.coordinates(around * here.second);
      const double cosine = first.x() + second.y(), sine = first.y() - second.x();
      const double length = std::hypot(cosine, sine);
      frames.push_back(length > 0 ? turned(there, cosine / length, sine / length) : there);
    }
    return frames;
  }

  /// How edges at each vertex lie on the target: the sum of what they become times what they are.
  std::vector<Eigen::Matrix3d> stretches(const SurfaceMap& images) const {
    const std::vector<Point>& rest = source_.mesh.vertices;
    std::vector<Point> places;
    for (const SurfacePoint& image : images) places.push_back(position(target_.mesh, image));
    std::vector<Eigen::Matrix3d> result(images.size(), Eigen::Matrix3d::Zero());
    for (int v = 0; v < source_.num_vertices(); ++v)
      for (const Connection::Link& link : connection_.links(v))
        result[v] +=
            link.weight * (places[link.to] - places[v]) * (rest[link.to] - rest[v]).transpose();
    return result;
  }

  /// What a vertex wants: where its image goes so that the forms there differ less.
  Pull pull(int v, const SurfacePoint& image, const TangentFrame& frame) const {
    Pull result;
    if (!inside_.empty() && !inside_[v]) return result;
    const Face& face = target_.mesh.faces[image.face];
    const double area = area_vector(target_.mesh.vertices, face).norm() / 2;
    if (area <= 0) return result;
    std::array<Point, 3> gradients = hat_gradients(target_.mesh, face);
    for (Point& gradient : gradients) gradient /= area;
    for (int k = 0; k < kSecondFormScales; ++k) {
      const Difference difference = this->difference(v, k, image, frame, gradients);
      // Geman and McClure's weight: where surfaces differ anyway, they tell nothing.
      const double doubt = 1 + difference.value.squaredNorm();
      const double weight = areas_[v] / (kSecondFormScales * doubt * doubt);
      result.stiffness += weight * difference.slope.transpose() * difference.slope;
      result.force -= weight * difference.slope.transpose() * difference.value;
    }
    return result;
  }

  /// At one scale, weighted.
  Difference difference(int v, int k, const SurfacePoint& image, const TangentFrame& frame,
                        const std::array<Point, 3>& gradients) const {
    const Face& face = target_.mesh.faces[image.face];
    Difference result{-form(v, k), Eigen::Matrix<double, 3, 2>::Zero()};
    for (int corner = 0; corner < 3; ++corner) {
      const Eigen::Vector3d there = components_in(frame, (*target_forms_)[face[corner]][k]);
      result.value += image.weights[corner] * there;
      result.slope += there * frame.coordinates(gradients[corner]).transpose();
    }
    result.value.array() *= weights_[k].array();
    result.slope.array().colwise() *= weights_[k].array();
    return result;
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
  Connection connection_;
  std::shared_ptr<const std::vector<SecondForm>> target_forms_;
  /// Of the source, in its frames.
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
