// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: 2026 The isomatch authors
#include "results/page/template.h"

// The assembler copies the file into the program; the compiler would take minutes.
asm(R"(
  .section .rodata
  isomatch_page_template_begin:
  .incbin ")" ISOMATCH_PAGE_TEMPLATE R"("
  isomatch_page_template_end:
  .previous
)");

extern const char kTemplateBegin[] asm("isomatch_page_template_begin");
extern const char kTemplateEnd[] asm("isomatch_page_template_end");

namespace isomatch::results {

std::string_view page_template() { return {kTemplateBegin, kTemplateEnd}; }

}  // namespace isomatch::results
