# Every library the kit uses, under the name hsr::NAME: the system's package where there is one,
# otherwise fetched at a pinned version. GMP alone must be installed, as it does not build with CMake.
include(FetchContent)
find_package(PkgConfig QUIET)

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

# Vectors and matrices.
find_package(glm QUIET)
if(NOT TARGET glm::glm)
  FetchContent_Declare(glm GIT_REPOSITORY https://github.com/g-truc/glm.git GIT_TAG 0.9.9.8)
  FetchContent_MakeAvailable(glm)
endif()
hsr_alias(glm glm::glm glm)

# Threads.
find_package(TBB QUIET CONFIG)
if(NOT TARGET TBB::tbb)
  set(TBB_TEST OFF CACHE BOOL "" FORCE)
  FetchContent_Declare(tbb GIT_REPOSITORY https://github.com/oneapi-src/oneTBB.git GIT_TAG v2021.8.0)
  FetchContent_MakeAvailable(tbb)
endif()
hsr_alias(tbb TBB::tbb)

# OpenEXR images.
find_package(OpenEXR QUIET CONFIG)
if(NOT TARGET OpenEXR::OpenEXR)
  set(OPENEXR_INSTALL OFF CACHE BOOL "" FORCE)
  set(OPENEXR_BUILD_TOOLS OFF CACHE BOOL "" FORCE)
  FetchContent_Declare(openexr
                       GIT_REPOSITORY https://github.com/AcademySoftwareFoundation/openexr.git
                       GIT_TAG v3.1.5)
  FetchContent_MakeAvailable(openexr)
endif()
hsr_alias(openexr OpenEXR::OpenEXR)

# JSON.
find_package(nlohmann_json QUIET CONFIG)
if(NOT TARGET nlohmann_json::nlohmann_json)
  FetchContent_Declare(json GIT_REPOSITORY https://github.com/nlohmann/json.git GIT_TAG v3.11.2)
  FetchContent_MakeAvailable(json)
endif()
hsr_alias(json nlohmann_json::nlohmann_json)

# Command line.
find_package(CLI11 QUIET CONFIG)
if(NOT TARGET CLI11::CLI11)
  FetchContent_Declare(cli11 GIT_REPOSITORY https://github.com/CLIUtils/CLI11.git GIT_TAG v2.1.2)
  FetchContent_MakeAvailable(cli11)
endif()
hsr_alias(cli11 CLI11::CLI11)

# Compressed files.
find_package(ZLIB QUIET)
if(NOT TARGET ZLIB::ZLIB)
  FetchContent_Declare(zlib GIT_REPOSITORY https://github.com/madler/zlib.git GIT_TAG v1.3.1)
  FetchContent_MakeAvailable(zlib)
  target_include_directories(zlibstatic INTERFACE ${zlib_SOURCE_DIR} ${zlib_BINARY_DIR})
endif()
hsr_alias(zlib ZLIB::ZLIB zlibstatic)

# PNG files (single header).
find_path(STB_INCLUDE_DIR stb/stb_image_write.h)
if(NOT STB_INCLUDE_DIR)
  FetchContent_Declare(stb GIT_REPOSITORY https://github.com/nothings/stb.git
                       GIT_TAG 8b5f1f37b5b75829fc72d38e7b5d4bcbf8a26d55
                       SOURCE_SUBDIR none
                       SOURCE_DIR ${CMAKE_BINARY_DIR}/_deps/stb-parent/stb)
  FetchContent_MakeAvailable(stb)
  set(STB_INCLUDE_DIR ${CMAKE_BINARY_DIR}/_deps/stb-parent CACHE PATH "" FORCE)
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
if(BUILD_TESTING OR NOT DEFINED BUILD_TESTING)
  find_package(doctest QUIET CONFIG)
  if(NOT TARGET doctest::doctest)
    FetchContent_Declare(doctest GIT_REPOSITORY https://github.com/doctest/doctest.git GIT_TAG v2.4.9)
    FetchContent_MakeAvailable(doctest)
    list(APPEND CMAKE_MODULE_PATH ${doctest_SOURCE_DIR}/scripts/cmake)
  endif()
  hsr_alias(doctest doctest::doctest doctest)
endif()
