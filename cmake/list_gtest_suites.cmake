# Writes LIST, which declares a test for each suite of PROGRAM. See gtest_suites.cmake.
execute_process(COMMAND ${PROGRAM} --gtest_list_tests
                OUTPUT_VARIABLE listing COMMAND_ERROR_IS_FATAL ANY)
string(REGEX MATCHALL "(^|\n)[^ \n]+\\." suites "${listing}")
get_filename_component(program ${PROGRAM} NAME)
set(declarations)
foreach(suite IN LISTS suites)
  string(STRIP "${suite}" suite)
  string(APPEND declarations
    "add_test([=[${program}.${suite}]=] [=[${PROGRAM}]=] [=[--gtest_filter=${suite}*]=])\n"
    "set_tests_properties([=[${program}.${suite}]=] PROPERTIES ENVIRONMENT OMP_WAIT_POLICY=passive)\n")
endforeach()
file(WRITE ${LIST} "${declarations}")
