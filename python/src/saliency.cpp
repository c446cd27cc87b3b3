// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/saliency.h"

#include "arrays.h"
#include "bindings.h"
#include "options.h"
#include "prepared.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::array_t<double> integral(const PreparedMesh& input, const py::dict& keywords,
                             const RunOptions& how) {
  const auto options = to_options<SaliencyOptions>(keywords);
  return adopt(run(how, [&](const Context& context) {
    return input_values(input.surface(),
                        integral_geodesic_distance(input.shape(context), options, context));
  }));
}

py::array_t<double> curvature(const PreparedMesh& input, const py::dict& keywords,
                              const RunOptions& how) {
  const auto options = to_options<SaliencyOptions>(keywords);
  return adopt(run(how, [&](const Context& context) {
    return input_values(input.surface(), gaussian_curvature(input.shape(context), options));
  }));
}

}  // namespace

void bind_saliency(py::module_& module) {
  register_options<SaliencyOptions>(module, "saliency");
  module.def("integral_geodesic_distance", integral);
  module.def("gaussian_curvature", curvature);
}

}  // namespace isomatch::python
