// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/mesh/synth.h"

#include "arrays.h"
#include "bindings.h"
#include "options.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::dict make_synth_shape(const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<SynthOptions>(keywords);
  SynthShape shape = run(how, [&](const Context& context) { return synthesize(options, context); });
  py::dict result;
  result["vertices"] = to_array(std::move(shape.mesh.vertices));
  result["faces"] = to_array(std::move(shape.mesh.faces));
  result["rest"] = to_array(std::move(shape.rest));
  result["ground_truth"] = adopt(std::move(shape.ground_truth));
  result["symmetric_ground_truth"] = adopt(std::move(shape.symmetric_ground_truth));
  return result;
}

}  // namespace

void bind_synth(py::module_& module) {
  register_options<SynthOptions>(module, "synth");
  module.def("synthesize", make_synth_shape);
}

}  // namespace isomatch::python
