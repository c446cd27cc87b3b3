add_library(isomatch_warnings INTERFACE)
target_compile_options(
  isomatch_warnings INTERFACE -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Wno-sign-conversion
                              $<$<BOOL:${ISOMATCH_WARNINGS_AS_ERRORS}>:-Werror>)
# GCC takes the sources that a unity build joins for headers (-Wsubobject-linkage), and misjudges a
# string that it inlined everywhere (the others, bug 105329 of GCC 12).
if(CMAKE_UNITY_BUILD AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  target_compile_options(isomatch_warnings INTERFACE -Wno-subobject-linkage
                         -Wno-array-bounds -Wno-stringop-overread)
endif()
