# One way to declare a library and a test, so that every target gets the same standard, warnings and sanitizers.

set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# -O2 without value-changing floating point: results must not depend on the optimiser's mood.
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG")
set(CMAKE_CXX_FLAGS_DEBUG "-Og -g")

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM)
  set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
  set(CMAKE_C_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

add_library(FalciformOptions INTERFACE)
target_include_directories(FalciformOptions INTERFACE ${CMAKE_SOURCE_DIR} ${CMAKE_BINARY_DIR}/generated)
target_compile_options(FalciformOptions INTERFACE
  $<$<COMPILE_LANGUAGE:CXX>:-Wall -Wextra -Wshadow -Wnon-virtual-dtor -Woverloaded-virtual -Werror>)
if(FALCIFORM_SANITIZE)
  target_compile_options(FalciformOptions INTERFACE -fsanitize=address,undefined -fno-sanitize-recover=undefined)
  target_link_options(FalciformOptions INTERFACE -fsanitize=address,undefined)
endif()

# falciform_library(Core SOURCES a.cpp ... DEPENDS Falciform::X ... [PRIVATE_DEPENDS ...])
function(falciform_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;DEPENDS;PRIVATE_DEPENDS" ${ARGN})
  add_library(Falciform${name} STATIC ${ARG_SOURCES})
  add_library(Falciform::${name} ALIAS Falciform${name})
  target_link_libraries(Falciform${name} PUBLIC FalciformOptions ${ARG_DEPENDS} PRIVATE ${ARG_PRIVATE_DEPENDS})
endfunction()

# falciform_vtk(target COMPONENT ...): links VTK modules and marks their headers as system headers.
function(falciform_vtk target)
  find_package(VTK 9.1 REQUIRED COMPONENTS ${ARGN})
  foreach(component ${ARGN})
    target_link_libraries(${target} PRIVATE VTK::${component})
  endforeach()
endfunction()

# falciform_test(RegistrationTests LABEL logic SOURCES a.cpp ... DEPENDS Falciform::X ... [ENVIRONMENT VAR=value] [TIMEOUT s] [TOGETHER])
# One GoogleTest executable, its cases found at test time, each labelled with its layer (Docs/Testing.md). TOGETHER: all cases are one
# test of one process, for those that share what takes long to make; ctest shows what the process says of each that fails.
include(GoogleTest)
function(falciform_test name)
  cmake_parse_arguments(ARG "TOGETHER" "LABEL;TIMEOUT" "SOURCES;DEPENDS;ENVIRONMENT" ${ARGN})
  if(NOT ARG_TIMEOUT)
    set(ARG_TIMEOUT 120)
  endif()
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE FalciformOptions ${ARG_DEPENDS} GTest::gmock GTest::gtest_main)
  if(ARG_TOGETHER)
    add_test(NAME ${name} COMMAND ${name} --gtest_brief=1)
    set_tests_properties(${name} PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${ARG_ENVIRONMENT}")
    return()
  endif()
  list(JOIN ARG_ENVIRONMENT "\\;" environment)  # one property value, not several
  gtest_discover_tests(${name} DISCOVERY_MODE PRE_TEST
    PROPERTIES LABELS ${ARG_LABEL} TIMEOUT ${ARG_TIMEOUT} ENVIRONMENT "${environment}")
endfunction()
