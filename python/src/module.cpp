// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "bindings.h"
#include "isomatch/context.h"
#include "isomatch/error.h"
#include "isomatch/version.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

/// The others become ValueError and RuntimeError by their base classes.
void translate_errors(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const BadFile& error) {
    // Names of files need not be UTF-8.
    const auto message = py::reinterpret_steal<py::object>(PyUnicode_DecodeFSDefault(error.what()));
    PyErr_SetObject(PyExc_OSError, message.ptr());
  }
}

}  // namespace
}  // namespace isomatch::python

PYBIND11_MODULE(_core, module) {
  using namespace isomatch::python;
  py::register_exception_translator(translate_errors);
  module.attr("version") = isomatch::kVersion;
  module.def("hardware_threads", isomatch::hardware_threads);
  bind_meshes(module);
  bind_geodesics(module);
  bind_saliency(module);
  bind_sampling(module);
  bind_metrics(module);
  bind_transfer(module);
  bind_textures(module);
  bind_synth(module);
  bind_tracked(module);
  bind_paper(module);
  bind_maps(module);
  bind_folder(module);
  bind_group(module);
  bind_shape_model(module);
  bind_page(module);
}
