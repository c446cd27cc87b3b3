// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page.h"

#include <pybind11/stl.h>

#include "bindings.h"
#include "isomatch/io/atomic_file.h"
#include "match.h"
#include "results/files/outputs.h"
#include "results/page/template.h"

namespace py = pybind11;

namespace isomatch::python {

void bind_page(py::module_& module) {
  py::class_<SavedAs>(module, "SavedAs")
      .def(py::init<std::string, std::string, std::string, std::string, std::vector<std::string>,
                    bool, bool>());
  module.def("has_page", [] { return !results::page_template().empty(); });
  module.def("check_page", [](const std::string& path, const std::vector<std::string>& meshes) {
    results::check_page_available();
    results::check_ending(path, {".html", ".htm"});
    results::check_output(path, results::InputFiles(meshes));
  });
  module.def("write_file", [](const std::string& path, const std::string& content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
  });
}

}  // namespace isomatch::python
