// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <fmt/format.h>
#include <pybind11/pybind11.h>

#include <algorithm>
#include <string>

#include "isomatch/option_fields.h"
#include "results/option_names.h"

/// Options of the library as keywords, derived from `for_each_option`, under the names that the
/// command line has for them.
namespace isomatch::python {

/// The keyword of a field.
inline std::string keyword(const char* field) {
  std::string name = results::option_name(field);
  std::ranges::replace(name, '-', '_');
  return name;
}

/// An option's value in Python: words for enumerations, otherwise the value itself.
template <class Value>
pybind11::object to_python(const Value& value) {
  return pybind11::cast(value);
}
inline pybind11::object to_python(const GeodesicArcs& arcs) {
  return pybind11::str(arcs == GeodesicArcs::kEdges ? "edges" : "visibility");
}

template <class Value>
void from_python(const pybind11::handle& value, Value& result) {
  result = value.cast<Value>();
}
inline void from_python(const pybind11::handle& value, GeodesicArcs& result) {
  const std::string word = value.cast<std::string>();
  if (word != "edges" && word != "visibility")
    throw pybind11::value_error("arcs: expected 'edges' or 'visibility', not '" + word + "'");
  result = word == "edges" ? GeodesicArcs::kEdges : GeodesicArcs::kVisibility;
}

template <class Value>
void set_option(const char* name, const pybind11::object& given, Value& value) {
  try {
    from_python(given, value);
  } catch (const pybind11::cast_error&) {
    const pybind11::str type = pybind11::type::of(to_python(value)).attr("__name__");
    throw pybind11::type_error(fmt::format("{}: expected {}, not {}", name,
                                           type.cast<std::string>(),
                                           pybind11::repr(given).cast<std::string>()));
  }
}

/// `Options` with the values of `keywords` in place of defaults, validated if values can be wrong.
/// Throws TypeError for a keyword that is no option and for a value of another type.
template <class Options>
Options to_options(const pybind11::dict& keywords) {
  Options options;
  std::size_t used = 0;
  for_each_option(options, [&](const char* field, auto& value, const char*) {
    const std::string name = keyword(field);
    if (!keywords.contains(name)) return;
    set_option(name.c_str(), keywords[name.c_str()], value);
    ++used;
  });
  if (used != keywords.size()) throw pybind11::type_error("unknown option");
  if constexpr (requires { options.validate(); }) options.validate();
  return options;
}

/// (name, default, meaning) of each option.
template <class Options>
pybind11::list describe_options() {
  pybind11::list list;
  const Options defaults{};
  for_each_option(defaults, [&](const char* field, const auto& value, const char* meaning) {
    list.append(pybind11::make_tuple(keyword(field), to_python(value), meaning));
  });
  return list;
}

/// Adds `describe_options` to the dictionary `options` of `module` as `name`.
template <class Options>
void register_options(pybind11::module_& module, const char* name) {
  if (!pybind11::hasattr(module, "options")) module.attr("options") = pybind11::dict();
  module.attr("options")[name] = describe_options<Options>();
}

}  // namespace isomatch::python
