// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/sampling.h"

#include "arrays.h"
#include "bindings.h"
#include "isomatch/methods/paper.h"
#include "options.h"
#include "prepared.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::array_t<int> sample(const PreparedMesh& input, double radius, const py::array& order,
                        const RunOptions& how) {
  const Surface& surface = input.surface();
  const std::vector<int> first = surface_numbers(surface, to_integers(order, "order"), "order");
  return adopt(run(how, [&](const Context& context) {
    const Shape& shape = input.shape(context);
    const auto scaled = static_cast<float>(radius / shape.unit);
    return input_numbers(surface, sample_bases(shape, first, {}, scaled, context).bases);
  }));
}

py::tuple sample_both(const PreparedMesh& source, const PreparedMesh& target, int level,
                      const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<PaperOptions>(keywords);
  const JointSampling bases = run(how, [&](const Context& context) {
    return sample_jointly(source.shape(context), target.shape(context), level, options, context);
  });
  return py::make_tuple(adopt(input_numbers(source.surface(), bases.source)),
                        adopt(input_numbers(target.surface(), bases.target)));
}

}  // namespace

void bind_sampling(py::module_& module) {
  module.def("sample_bases", sample);
  module.def("sample_jointly", sample_both);
}

}  // namespace isomatch::python
