# Every library the kit uses, under the name hsr::NAME: the system's package where there is one
# (viewer/setup lists them), otherwise fetched at a pinned version. GMP alone must be installed, as
# it does not build with CMake.
include(FetchContent)

# Makes hsr::NAME an alias of the first of the given targets that exists.
function(hsr_alias name)
  foreach(target ${ARGN})
    if(TARGET ${target})
      add_library(hsr_${name} INTERFACE)
      target_link_libraries(hsr_${name} INTERFACE ${target})
      add_library(hsr::${name} ALIAS hsr_${name})
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "no target for ${name}: none of ${ARGN} exists")
endfunction()

# Fetches a library that the system does not have and adds its targets: without its tests, and with
# its headers as system headers, so that our warnings stay ours.
function(hsr_fetch name repository tag)
  message(STATUS "${name} is not installed: fetching ${tag}")
  set(BUILD_TESTING OFF)
  set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)  # option() leaves variables that are set alone
  FetchContent_Declare(${name} GIT_REPOSITORY ${repository} GIT_TAG ${tag} ${ARGN})
  set_directory_properties(PROPERTIES SYSTEM ON)  # FetchContent's own SYSTEM fails in CMake 3.25.1
  FetchContent_MakeAvailable(${name})
  set_directory_properties(PROPERTIES SYSTEM OFF)
  set(${name}_SOURCE_DIR ${${name}_SOURCE_DIR} PARENT_SCOPE)
  set(${name}_BINARY_DIR ${${name}_BINARY_DIR} PARENT_SCOPE)
endfunction()

# Vectors and matrices.
find_package(glm QUIET)
if(NOT TARGET glm::glm)
  hsr_fetch(glm https://github.com/g-truc/glm.git 0.9.9.8)
endif()
hsr_alias(glm glm::glm)

# Threads.
find_package(TBB QUIET CONFIG)
if(NOT TARGET TBB::tbb)
  set(TBB_TEST OFF CACHE BOOL "" FORCE)
  hsr_fetch(tbb https://github.com/oneapi-src/oneTBB.git v2021.8.0)
endif()
hsr_alias(tbb TBB::tbb)

# Vector instructions: one text for AVX-512, AVX2, SSE4 and NEON, the best of the machine chosen at run time.
find_package(hwy QUIET CONFIG)
if(NOT TARGET hwy::hwy)
  set(HWY_ENABLE_CONTRIB OFF CACHE BOOL "" FORCE)
  set(HWY_ENABLE_EXAMPLES OFF CACHE BOOL "" FORCE)
  set(HWY_ENABLE_INSTALL OFF CACHE BOOL "" FORCE)
  set(HWY_ENABLE_TESTS OFF CACHE BOOL "" FORCE)
  hsr_fetch(highway https://github.com/google/highway.git 1.0.3)
endif()
hsr_alias(highway hwy::hwy hwy)
# Each instruction set is a compilation of its own, so they are few. The plain one is SSE4, which every x86
# of the last fifteen years has. Sanitizers see the same text whatever the set, so one set is enough there.
set(HSR_INSTRUCTION_SETS "" CACHE STRING "On x86: sse4 to build the fast versions for that set alone")
if(CMAKE_SYSTEM_PROCESSOR MATCHES "^(x86_64|AMD64)$")
  set(hsr_disabled_sets "(HWY_AVX3_DL|HWY_SSSE3|HWY_SCALAR)")
  if(HSR_SANITIZE OR HSR_INSTRUCTION_SETS STREQUAL "sse4")
    set(hsr_disabled_sets "(HWY_AVX3_DL|HWY_AVX3|HWY_AVX2|HWY_SSSE3|HWY_SCALAR)")
  endif()
  target_compile_definitions(hsr_highway INTERFACE "HWY_BASELINE_TARGETS=HWY_SSE4"
                             "HWY_DISABLED_TARGETS=${hsr_disabled_sets}")
else()
  # Vectors whose length is known only at run time cannot be members of our structures.
  target_compile_definitions(hsr_highway INTERFACE
                             "HWY_DISABLED_TARGETS=(HWY_SVE|HWY_SVE2|HWY_SVE_256|HWY_SVE2_128)")
endif()

# Compressed files; OpenEXR needs it too.
find_package(ZLIB QUIET)
if(NOT TARGET ZLIB::ZLIB)
  hsr_fetch(zlib https://github.com/madler/zlib.git v1.3.1)
  target_include_directories(zlibstatic INTERFACE ${zlib_SOURCE_DIR} ${zlib_BINARY_DIR})
  set_target_properties(zlibstatic PROPERTIES POSITION_INDEPENDENT_CODE ON)  # OpenEXR is shared
  add_library(ZLIB::ZLIB ALIAS zlibstatic)
endif()
hsr_alias(zlib ZLIB::ZLIB)

# OpenEXR images. Debian's package of Imath, which OpenEXR needs, mentions a Python library that is
# in another package and prints a paragraph about it, hence the log level.
block()
  set(CMAKE_MESSAGE_LOG_LEVEL WARNING)
  find_package(OpenEXR QUIET CONFIG)
endblock()
if(NOT TARGET OpenEXR::OpenEXR)
  set(OPENEXR_INSTALL OFF CACHE BOOL "" FORCE)
  set(OPENEXR_INSTALL_TOOLS OFF CACHE BOOL "" FORCE)
  set(OPENEXR_BUILD_TOOLS OFF CACHE BOOL "" FORCE)
  set(OPENEXR_FORCE_INTERNAL_IMATH ON CACHE BOOL "" FORCE)  # it finds its own half on a second run
  set(OPENEXR_INSTALL_EXAMPLES OFF CACHE BOOL "" FORCE)
  hsr_fetch(openexr https://github.com/AcademySoftwareFoundation/openexr.git v3.1.5)
endif()
hsr_alias(openexr OpenEXR::OpenEXR)
if(openexr_SOURCE_DIR)
  target_include_directories(hsr_openexr SYSTEM INTERFACE ${openexr_SOURCE_DIR}/src/lib)  # <OpenEXR/...>
endif()

# GIF animations. giflib has no build for CMake.
find_package(GIF 5.1 QUIET)
if(NOT TARGET GIF::GIF)
  enable_language(C)
  hsr_fetch(gif https://git.code.sf.net/p/giflib/code 5.2.1 SOURCE_SUBDIR none)
  add_library(gif_fetched STATIC
    ${gif_SOURCE_DIR}/dgif_lib.c ${gif_SOURCE_DIR}/egif_lib.c ${gif_SOURCE_DIR}/gif_err.c
    ${gif_SOURCE_DIR}/gif_hash.c ${gif_SOURCE_DIR}/gifalloc.c ${gif_SOURCE_DIR}/openbsd-reallocarray.c)
  target_include_directories(gif_fetched SYSTEM PUBLIC ${gif_SOURCE_DIR})
  add_library(GIF::GIF ALIAS gif_fetched)
endif()
hsr_alias(gif GIF::GIF)

# JSON.
find_package(nlohmann_json QUIET CONFIG)
if(NOT TARGET nlohmann_json::nlohmann_json)
  hsr_fetch(json https://github.com/nlohmann/json.git v3.11.2)
endif()
hsr_alias(json nlohmann_json::nlohmann_json)

# Command line.
find_package(CLI11 QUIET CONFIG)
if(NOT TARGET CLI11::CLI11)
  hsr_fetch(cli11 https://github.com/CLIUtils/CLI11.git v2.1.2)
endif()
hsr_alias(cli11 CLI11::CLI11)

# PNG files, read back by the tests: headers without a build of their own, included as <stb/stb_image.h>.
find_path(STB_INCLUDE_DIR stb/stb_image_write.h)
if(NOT STB_INCLUDE_DIR)
  hsr_fetch(stb https://github.com/nothings/stb.git 8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55
            SOURCE_SUBDIR none SOURCE_DIR ${CMAKE_BINARY_DIR}/_deps/stb-parent/stb)
  set(STB_INCLUDE_DIR ${stb_SOURCE_DIR}/.. CACHE PATH "" FORCE)
endif()
add_library(stb_headers INTERFACE)
target_include_directories(stb_headers SYSTEM INTERFACE ${STB_INCLUDE_DIR})
hsr_alias(stb stb_headers)

# Exact integers.
find_path(GMP_INCLUDE_DIR gmpxx.h)
find_library(GMP_LIBRARY gmp)
find_library(GMPXX_LIBRARY gmpxx)
if(NOT GMP_INCLUDE_DIR OR NOT GMP_LIBRARY OR NOT GMPXX_LIBRARY)
  message(FATAL_ERROR "GMP with its C++ interface was not found: install libgmp-dev (Debian, Ubuntu), "
                      "gmp-devel (Fedora) or gmp (Homebrew)")
endif()
add_library(gmp_libraries INTERFACE)
target_include_directories(gmp_libraries SYSTEM INTERFACE ${GMP_INCLUDE_DIR})
target_link_libraries(gmp_libraries INTERFACE ${GMPXX_LIBRARY} ${GMP_LIBRARY})
hsr_alias(gmp gmp_libraries)

# Tests.
if(BUILD_TESTING)
  find_package(doctest QUIET CONFIG)
  if(NOT TARGET doctest::doctest)
    hsr_fetch(doctest https://github.com/doctest/doctest.git v2.4.9)
    list(APPEND CMAKE_MODULE_PATH ${doctest_SOURCE_DIR}/scripts/cmake)
  endif()
  hsr_alias(doctest doctest::doctest doctest)
endif()
