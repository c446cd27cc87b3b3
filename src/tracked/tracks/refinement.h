// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "isomatch/context.h"
#include "tracked/hypotheses/judging.h"
#include "tracked/tracks/overlap.h"

namespace isomatch::tracked {

/// A hypothesis on its way to a map.
struct Track {
  Judged judged;
  /// The level that it is on.
  const Level* source;
  const Level* target;
  /// Nodes of the source, with the places on the target where they are.
  elastic::PointCloud cloud;
  /// The target's proxy vertices that are nearest to the nodes.
  std::vector<int> vertices;
  elastic::Deformation deformation;
  elastic::Registration registration;
  /// More than 1 for mirror images and motions in space, see `Options::mirror_price` and
  /// `PoseOptions::price`.
  double price = 1;
  /// What is left out on both sides, as elastic energy and as distance.
  double energy_left_out = 0, distance_left_out = 0;
  /// The parts that overlapped when it was last looked at; none where nothing is missing.
  std::shared_ptr<const Overlap> overlap = nullptr;
  /// Whether the nodes are somewhere yet.
  bool placed = false;

  /// How badly the surfaces fit, to be compared on one level. The energy of the fine registration
  /// is large where a map is torn, the distance where it leaves bulges of the target uncovered.
  double cost() const {
    return price * (registration.energy + energy_left_out) *
           (registration.distance + distance_left_out);
  }
};

/// Carries hypotheses on to maps onto one target. Spectral steps know distances along the surface,
/// registrations know its shape in space; in turn they correct each other, from smooth to fine.
class Refinement {
 public:
  /// Keeps references to the first two. What it does throws `Cancelled` soon after a stop.
  Refinement(const Pyramid& target, const Options& options, const Context& context = {});

  /// The hypothesis after a first registration, on the middle level.
  Track begin(const Judged& judged) const;
  /// The track after the rounds on the middle level, mended if it fits better then.
  Track follow(Track track) const;
  /// The track after the remaining rounds, on the fine level.
  Track finish(const Track& middle) const;
  /// Turns the end of a limb of a finished track by half, if the surfaces fit better for it.
  void turn_an_end(Track& track) const;
  /// The last rounds of a track on the fine level, `first` and later ones, that begins at
  /// `vertices`, or, if it is a motion in space, at `positions`; `inside` are the nodes that have a
  /// counterpart.
  Track fine_rounds(const Judged& judged, std::vector<int> vertices, std::vector<bool> inside,
                    int first, std::vector<Point> positions = {}) const;
  /// A last registration of a track on the fine level, close to `anchors`.
  void settle(Track& track, std::span<const Point> anchors) const;
  /// A track on the fine level that only settles: its nodes are at `anchors`, near these vertices
  /// of the target's proxy. Of nodes that are not inside the anchors do not count.
  Track settled(const Judged& judged, std::vector<int> vertices, std::vector<bool> inside,
                std::vector<Point> anchors) const;
  /// For each target node the nearest node of the deformed source.
  std::vector<int> nearest_nodes(const Track& track) const;
  /// The target nodes that the source covers, given the nearest nodes. Empty where nothing is
  /// missing.
  std::vector<bool> covered_target(const Track& track, const std::vector<int>& nearest) const;

 private:
  Track enter(const Judged& judged, const Level& source, const Level& target,
              std::vector<int> vertices, std::vector<bool> inside) const;
  Track registered(const Judged& judged, const Level& source, const Level& target) const;
  void mend(Track& track) const;
  void extend(Track& track) const;
  void replace_if_better(Track& track, Track other) const;
  std::vector<int> spectral_step(Track& track, const Level& wanted, int round) const;
  static std::vector<Point> carried(const Track& track, const Level& wanted);
  std::vector<int> carried_vertices(const Track& track, const Level& wanted) const;
  std::vector<int> overlap_step(Track& track, const Level& wanted, int round) const;
  std::shared_ptr<const Overlap> overlap_of(const Track& track, const std::vector<int>& nearest,
                                            int functions) const;
  void look_at_overlap(Track& track) const;
  double covering_reach(const Track& track) const;
  double distance_uncovered(const Track& track) const;
  void weigh_left_out(Track& track) const;
  static bool is_fine(const Track& track);
  const elastic::Projection& surface_of(const Track& track) const;
  void run_round(Track& track, int round) const;
  void advance(Track& track, const elastic::Projection& onto,
               const elastic::RegistrationOptions& step) const;
  void advance(Track& track, const elastic::Projection& onto,
               const elastic::RegistrationOptions& step, std::span<const Point> anchors) const;
  double progress(int round) const;
  int basis_size(int round) const;

  const Pyramid& target_;
  const Options& options_;
  Context context_;
  elastic::Projection early_surface_, middle_surface_, fine_surface_, posed_surface_;
};

/// Root mean square distance between the images of the nodes, on one level.
double difference(const Track& a, const Track& b);

}  // namespace isomatch::tracked
