// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>

#include "io/mesh/checks.h"
#include "io/mesh/formats.h"
#include "io/mesh/ply_body.h"
#include "io/mesh/ply_colors.h"
#include "io/mesh/ply_header.h"
#include "io/mesh/polygon.h"

namespace isomatch::mesh_io {
namespace {

constexpr int kNoAxis = -1;
constexpr std::size_t kNoList = -1;
/// In the lists of "tristrips", ends one strip and begins the next.
constexpr std::int64_t kStripEnd = -1;

/// Reads the elements "vertex", "face" and "tristrips" and passes over all others.
template <class Body>
class PlyReader {
 public:
  PlyReader(const InputFile& file, const PlyHeader& header)
      : file_(&file), header_(&header), body_(file, header) {
    if (const PlyElement* vertex = header.find("vertex")) num_vertices_ = vertex->count;
  }

  /// Reads vertex colours besides, if there are any.
  ReadResult read_with_colors() {
    if (const PlyElement* vertex = header_->find("vertex")) colors_ = PlyColors(*vertex);
    ReadResult result = read();
    if (!colors_.empty()) result.colors = colors_.take(*file_);
    return result;
  }

  ReadResult read() {
    for (const PlyElement& element : header_->elements) {
      if (element.name == "vertex")
        read_vertices(element);
      else if (element.name == "face")
        read_faces(element);
      else if (element.name == "tristrips")
        read_strips(element);
      else
        read_lists(element, kNoList, [](std::int64_t, PlyType) {});
    }
    if (!body_.at_end())
      result_.report.warnings.emplace_back("more follows than the file announces; it is left out");
    return std::move(result_);
  }

 private:
  void read_vertices(const PlyElement& element) {
    if (element.count == 0) return;
    const std::vector<int> axes = property_axes(element);
    result_.mesh.vertices.reserve(element.count);
    for (int i = 0; i < element.count; ++i) {
      body_.begin_element(element, i);
      Point point;
      Eigen::Vector3d color = Eigen::Vector3d::Zero();
      for (std::size_t k = 0; k < axes.size(); ++k) {
        const PlyType type = element.properties[k].type;
        if (axes[k] != kNoAxis)
          point[axes[k]] = body_.scalar(type);
        else if (colors_.channel(k) != PlyColors::kNoChannel)
          color[colors_.channel(k)] = checked_intensity(type);
        else
          skip(element.properties[k]);
      }
      body_.end_element();
      result_.mesh.vertices.push_back(point);
      if (!colors_.empty()) colors_.add(color);
    }
  }

  double checked_intensity(PlyType type) {
    const double value = body_.scalar(type);
    if (!std::isfinite(value)) body_.fail(fmt::format("the colour {} is not finite", value));
    return value;
  }

  void read_faces(const PlyElement& element) {
    if (element.count == 0) return;
    result_.mesh.faces.reserve(result_.mesh.faces.size() + element.count);
    read_lists(element, index_list(element), [this](std::int64_t corners, PlyType type) {
      Polygon polygon(result_);
      for (std::int64_t corner = 0; corner < corners; ++corner)
        polygon.add_corner(checked_index(body_, whole_number(type), num_vertices_));
    });
  }

  void read_strips(const PlyElement& element) {
    if (element.count == 0) return;
    read_lists(element, index_list(element),
               [this](std::int64_t length, PlyType type) { read_strip(length, type); });
  }

  /// Each vertex forms a triangle with the two before it, in alternating orientation. Triangles
  /// with a repeated vertex only steer the strip and are no faces.
  void read_strip(std::int64_t length, PlyType type) {
    Face last{};
    std::int64_t corners = 0;
    for (std::int64_t i = 0; i < length; ++i) {
      const std::int64_t index = whole_number(type);
      if (index == kStripEnd) {
        corners = 0;
        continue;
      }
      last = {last[1], last[2], checked_index(body_, index, num_vertices_)};
      const auto [a, b, c] = last;
      if (++corners < 3 || a == b || b == c || c == a) continue;
      result_.mesh.faces.push_back(corners % 2 == 1 ? last : Face{b, a, c});
    }
  }

  /// Passes over the elements except for their property number `list`, which is a list: calls
  /// `read_entries(length, type)` in front of its entries.
  template <class ReadEntries>
  void read_lists(const PlyElement& element, std::size_t list, const ReadEntries& read_entries) {
    for (int i = 0; i < element.count; ++i) {
      body_.begin_element(element, i);
      for (std::size_t k = 0; k < element.properties.size(); ++k) {
        const PlyProperty& property = element.properties[k];
        if (k == list)
          read_entries(list_length(property), property.type);
        else
          skip(property);
      }
      body_.end_element();
    }
  }

  void skip(const PlyProperty& property) {
    body_.skip(property.type, property.count_type ? list_length(property) : 1);
  }

  std::int64_t whole_number(PlyType type) {
    constexpr double kExact = 1LL << 53;
    const double value = body_.scalar(type);
    if (std::abs(value) <= kExact) {
      const auto whole = static_cast<std::int64_t>(value);
      if (static_cast<double>(whole) == value) return whole;
    }
    body_.fail(fmt::format("expected a whole number, found {}", value));
  }

  std::int64_t list_length(const PlyProperty& list) {
    const std::int64_t length = whole_number(*list.count_type);
    if (length < 0) body_.fail(fmt::format("a list of {} entries", length));
    return length;
  }

  /// For each property of the vertices 0, 1, 2 for x, y, z, or kNoAxis.
  std::vector<int> property_axes(const PlyElement& element) const {
    constexpr std::array<std::string_view, 3> kNames = {"x", "y", "z"};
    std::vector<int> axes(element.properties.size(), kNoAxis);
    for (int axis = 0; axis < 3; ++axis) {
      const auto is_axis = [&](const PlyProperty& property) {
        return property.name == kNames[axis] && !property.count_type;
      };
      axes[find_property(element, is_axis, kNames[axis])] = axis;
    }
    return axes;
  }

  std::size_t index_list(const PlyElement& element) const {
    const auto is_index_list = [](const PlyProperty& property) {
      return (property.name == "vertex_indices" || property.name == "vertex_index") &&
             property.count_type;
    };
    return find_property(element, is_index_list, "list vertex_indices");
  }

  template <class Predicate>
  std::size_t find_property(const PlyElement& element, const Predicate& predicate,
                            std::string_view missing) const {
    const auto& properties = element.properties;
    const auto found = std::find_if(properties.begin(), properties.end(), predicate);
    if (found == properties.end())
      file_->fail_at_line(element.place, fmt::format("element {} has no property {}",
                                                     in_quotes(element.name), missing));
    return found - properties.begin();
  }

  const InputFile* file_;
  const PlyHeader* header_;
  Body body_;
  int num_vertices_ = 0;
  /// Empty if colours are not read.
  PlyColors colors_;
  ReadResult result_;
};

/// Calls `use` with the reader for the file's encoding.
template <class Use>
ReadResult with_reader(const InputFile& file, const Use& use) {
  const PlyHeader header = read_ply_header(file);
  switch (header.format) {
    case PlyFormat::kAscii:
      return use(PlyReader<AsciiPlyBody>(file, header));
    case PlyFormat::kBinaryLittleEndian:
      return use(PlyReader<BinaryPlyBody<std::endian::little>>(file, header));
    case PlyFormat::kBinaryBigEndian:
      break;
  }
  return use(PlyReader<BinaryPlyBody<std::endian::big>>(file, header));
}

}  // namespace

ReadResult read_ply(const InputFile& file) {
  return with_reader(file, [](auto reader) { return reader.read(); });
}

ReadResult read_colored_ply(const InputFile& file) {
  return with_reader(file, [](auto reader) { return reader.read_with_colors(); });
}

}  // namespace isomatch::mesh_io
