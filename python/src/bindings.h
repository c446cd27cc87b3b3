// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <pybind11/pybind11.h>

namespace isomatch::python {

/// Each adds the functions and classes of one stage to the module `isomatch._core`. What they take
/// and give is described where users meet it, in the package's Python files.
void bind_meshes(pybind11::module_& module);
void bind_geodesics(pybind11::module_& module);
void bind_saliency(pybind11::module_& module);
void bind_sampling(pybind11::module_& module);
void bind_metrics(pybind11::module_& module);
void bind_transfer(pybind11::module_& module);
void bind_textures(pybind11::module_& module);
void bind_synth(pybind11::module_& module);
void bind_tracked(pybind11::module_& module);
void bind_paper(pybind11::module_& module);
void bind_maps(pybind11::module_& module);
void bind_folder(pybind11::module_& module);
void bind_group(pybind11::module_& module);
void bind_shape_model(pybind11::module_& module);
void bind_page(pybind11::module_& module);

}  // namespace isomatch::python
