# Builds the fuzzers beside the tests and runs each a fixed number of times. Longer runs:
# packaging/fuzz.sh. Sanitizer builds leave them out: they bring sanitizers of their own.
if(HANEI_SANITIZE)
  return()
endif()

set(fuzz_folder ${CMAKE_BINARY_DIR}/fuzz)
find_program(FUZZ_COMPILER NAMES clang++-14 clang++)
if(FUZZ_COMPILER AND NOT DEFINED FUZZ_COMPILER_WORKS)
  file(WRITE ${fuzz_folder}/probe.cpp
       "#include <cstdint>\nextern \"C\" int LLVMFuzzerTestOneInput(const std::uint8_t*, std::size_t) { return 0; }\n")
  execute_process(COMMAND ${FUZZ_COMPILER} -fsanitize=fuzzer,address,undefined ${fuzz_folder}/probe.cpp
                          -o ${fuzz_folder}/probe
                  RESULT_VARIABLE refused OUTPUT_QUIET ERROR_QUIET)
  if(refused EQUAL 0)
    set(FUZZ_COMPILER_WORKS ON CACHE BOOL "FUZZ_COMPILER links fuzzers")
  endif()
endif()

if(FUZZ_COMPILER_WORKS)
  cmake_host_system_information(RESULT cores QUERY NUMBER_OF_LOGICAL_CORES)
  math(EXPR half_the_cores "(${cores} + 1) / 2")
  include(ExternalProject)
  ExternalProject_Add(fuzzers
    SOURCE_DIR ${CMAKE_CURRENT_LIST_DIR}
    BINARY_DIR ${fuzz_folder}
    CMAKE_ARGS -DCMAKE_CXX_COMPILER=${FUZZ_COMPILER}
    BUILD_COMMAND ${CMAKE_COMMAND} --build <BINARY_DIR> --parallel ${half_the_cores}
    BUILD_ALWAYS ON
    INSTALL_COMMAND "")
else()
  message(STATUS "No clang++ with libFuzzer: the tests fuzz.* will say skipped")
endif()

file(GLOB fuzz_targets CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/read_*.cpp)
foreach(source IN LISTS fuzz_targets)
  get_filename_component(fuzzer ${source} NAME_WE)
  string(REPLACE read_ "" target ${fuzzer})
  add_test(NAME fuzz.${target}
    COMMAND ${CMAKE_CURRENT_LIST_DIR}/run.sh ${target} ${fuzz_folder}/${fuzzer} - ${HANEI_SHARED} -runs=5000 -seed=1
    WORKING_DIRECTORY ${CMAKE_BINARY_DIR})
  set_tests_properties(fuzz.${target} PROPERTIES SKIP_RETURN_CODE 77 TIMEOUT 600)
endforeach()
