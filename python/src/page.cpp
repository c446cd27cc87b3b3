// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/page.h"

#include <pybind11/stl.h>

#include "bindings.h"
#include "isomatch/io/atomic_file.h"
#include "match.h"
#include "results/page/template.h"
#include "run.h"

namespace py = pybind11;

namespace isomatch::python {
namespace {

void write_page_file(const std::string& path, const SavedAs& saved, const std::string& source_truth,
                     const std::string& target_truth, const RunOptions& how) {
  cli::PageOptions options;
  options.truth.source = source_truth;
  options.truth.target = target_truth;
  run_work(how, [&](const Context& context) {
    cli::write_page(path, saved.folder, {saved.source, saved.target}, options, context);
  });
}

}  // namespace

void bind_page(py::module_& module) {
  py::class_<SavedAs>(module, "SavedAs")
      .def(py::init<std::string, std::string, std::string, std::string, std::vector<std::string>,
                    bool, bool>());
  module.def("has_page", [] { return !cli::page_template().empty(); });
  module.def("write_page", write_page_file);
  module.def("check_page", [](const std::string& path, const std::vector<std::string>& meshes) {
    cli::check_page_available();
    cli::check_ending(path, {".html", ".htm"});
    cli::check_output(path, cli::InputFiles(meshes));
  });
  module.def("write_file", [](const std::string& path, const std::string& content) {
    AtomicFile file(path);
    file.write(content);
    file.commit();
  });
}

}  // namespace isomatch::python
