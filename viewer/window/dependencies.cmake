# What the window is made with, as algorithms/dependencies.cmake: the system's package where there is
# one, otherwise fetched at a pinned version.

# Window, input and drawing.
find_package(SDL2 QUIET CONFIG)
if(NOT TARGET SDL2::SDL2)
  set(SDL_TEST OFF CACHE BOOL "" FORCE)
  hsr_fetch(sdl2 https://github.com/libsdl-org/SDL.git release-2.26.5)
endif()
hsr_alias(sdl2 SDL2::SDL2)

# Buttons, sliders and tables. Only the core is used: viewer/window/bridge.cpp joins it to SDL. It is
# for the versions from 1.86 on that still know ImGuiIO::KeysDown.
find_package(PkgConfig QUIET)
if(PkgConfig_FOUND)
  pkg_check_modules(imgui QUIET IMPORTED_TARGET "imgui >= 1.86" "imgui < 1.91.5")
endif()
if(TARGET PkgConfig::imgui)
  hsr_alias(imgui PkgConfig::imgui)
else()
  hsr_fetch(imgui https://github.com/ocornut/imgui.git v1.86 SOURCE_SUBDIR none)
  add_library(imgui_core STATIC ${imgui_SOURCE_DIR}/imgui.cpp ${imgui_SOURCE_DIR}/imgui_draw.cpp
                                ${imgui_SOURCE_DIR}/misc/cpp/imgui_stdlib.cpp
                                ${imgui_SOURCE_DIR}/imgui_tables.cpp ${imgui_SOURCE_DIR}/imgui_widgets.cpp)
  target_include_directories(imgui_core SYSTEM PUBLIC ${imgui_SOURCE_DIR} ${imgui_SOURCE_DIR}/misc/cpp)
  hsr_alias(imgui imgui_core)
endif()
