// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "arrays.h"
#include "bindings.h"
#include "isomatch/methods/sampling.h"
#include "options.h"
#include "run.h"
#include "shapes.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::array_t<double> integral(const MatchInput& input, const py::dict& keywords,
                             const RunOptions& how) {
  const auto options = to_options<SaliencyOptions>(keywords);
  return adopt(run(how, [&](const Context& context) {
    return integral_geodesic_distance(input.shape, options, context);
  }));
}

py::array_t<double> curvature(const MatchInput& input, const py::dict& keywords,
                              const RunOptions& how) {
  const auto options = to_options<SaliencyOptions>(keywords);
  return adopt(run(how, [&](const Context& context) {
    return gaussian_curvature(input.shape, options, context);
  }));
}

}  // namespace

void bind_saliency(py::module_& module) {
  register_options<SaliencyOptions>(module, "saliency");
  module.def("integral_geodesic_distance", integral);
  module.def("gaussian_curvature", curvature);
  module.def("descending_order", [](const py::array& saliency) {
    const Doubles values = to_doubles(saliency, "saliency");
    return adopt(descending_order({values.data(), static_cast<std::size_t>(values.size())}));
  });
}

}  // namespace isomatch::python
