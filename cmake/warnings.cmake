add_library(isomatch_warnings INTERFACE)
target_compile_options(
  isomatch_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                              $<$<BOOL:${ISOMATCH_WARNINGS_AS_ERRORS}>:-Werror>)
