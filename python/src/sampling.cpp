// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "isomatch/methods/sampling.h"

#include "arrays.h"
#include "bindings.h"
#include "isomatch/methods/paper.h"
#include "options.h"
#include "run.h"
#include "shapes.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

py::array_t<int> sample(const MatchInput& input, double radius, const py::array& order,
                        const RunOptions& how) {
  const std::vector<int> first = to_integers(order, "order");
  return adopt(run(how, [&](const Context& context) {
    return sample_bases(input.shape, first, radius, context);
  }));
}

py::tuple sample_both(const MatchInput& source, const MatchInput& target, int level,
                      const py::dict& keywords, const RunOptions& how) {
  const auto options = to_options<PaperOptions>(keywords);
  JointSampling bases = run(how, [&](const Context& context) {
    return sample_jointly(source.shape, target.shape, level, options, context);
  });
  return py::make_tuple(adopt(std::move(bases.source)), adopt(std::move(bases.target)));
}

}  // namespace

void bind_sampling(py::module_& module) {
  module.def("sample_bases", sample);
  module.def("sample_jointly", sample_both);
}

}  // namespace isomatch::python
