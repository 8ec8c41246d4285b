# Asks a test program for its tests and writes them for CTest under their dotted names
# (gtest_discover_tests cannot rename): stage02_fill_triangle.shared_edge -> stage02.fill_triangle.shared_edge.
execute_process(COMMAND "${PROGRAM}" --gtest_list_tests OUTPUT_VARIABLE listing RESULT_VARIABLE result)
if(NOT result EQUAL 0)
  file(REMOVE "${PROGRAM}")
  message(FATAL_ERROR "${PROGRAM} cannot list its tests: ${result}")
endif()
string(REPLACE ";" "\\;" listing "${listing}")
string(REPLACE "\n" ";" lines "${listing}")
set(script "")
foreach(line IN LISTS lines)
  string(REGEX REPLACE " *#.*$" "" line "${line}") # GoogleTest's comments on parameters and types
  if(line MATCHES "^([^ ]+)\\.$")
    set(suite "${CMAKE_MATCH_1}")
  elseif(line MATCHES "^  ([^ ]+)$")
    set(test "${CMAKE_MATCH_1}")
    string(REGEX REPLACE "^([a-z]+[0-9]*)_" "\\1." dotted "${suite}")
    string(REPLACE "/" "." dotted "${dotted}.${test}")
    string(APPEND script "add_test([==[${dotted}]==] [==[${PROGRAM}]==] [==[--gtest_filter=${suite}.${test}]==])\n")
    string(APPEND script "set_tests_properties([==[${dotted}]==] PROPERTIES WORKING_DIRECTORY [==[${FOLDER}]==] "
           "SKIP_REGULAR_EXPRESSION [==[\\[  SKIPPED \\]]==] TIMEOUT 600 LABELS [==[${LABELS}]==] ${PROPERTIES})\n")
  endif()
endforeach()
file(WRITE "${OUTPUT}" "${script}")
