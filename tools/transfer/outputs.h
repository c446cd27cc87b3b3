// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include <string>

#include "transfer/job.h"

namespace isomatch::cli {

/// Throws `BadFile` if what `arguments` ask for could not be written: the ending is another one,
/// the place cannot be written, something would be overwritten that is read or that isomatch did
/// not write; or if there is no such image. Reads no mesh and leaves no trace.
void check_transfer(const TransferArguments& arguments);

/// The name of the file that a frame becomes, in the folder of frames.
std::string frame_name(const std::string& frame);

/// The file of materials that goes beside a textured output.
std::string material_output(const std::string& output);

}  // namespace isomatch::cli
