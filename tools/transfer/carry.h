// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#pragma once

#include "transfer/job.h"

namespace isomatch::cli {

/// Carries what the arguments name over and writes it. Throws `BadFile`.
void carry_values(const TransferJob& job, const TransferArguments& arguments);
void carry_labels(const TransferJob& job, const TransferArguments& arguments);
void carry_colors(const TransferJob& job, const TransferArguments& arguments);
void carry_landmarks(const TransferJob& job, const TransferArguments& arguments);
void carry_skin(const TransferJob& job, const TransferArguments& arguments);
void carry_texture(const TransferJob& job, const TransferArguments& arguments);
void carry_poses(const TransferJob& job, const TransferArguments& arguments);

}  // namespace isomatch::cli
