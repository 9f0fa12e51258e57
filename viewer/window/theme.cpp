#include "window/theme.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string>

#include "frame/srgb.h"
#include "scene/built_in/okabe_ito.h"

namespace hsr::window {
namespace {

/// Of a colour as 0xRRGGBB.
ImU32 color(std::uint32_t word, unsigned opacity = 255U) {
  return IM_COL32(word >> 16U & 255U, word >> 8U & 255U, word & 255U, opacity);
}

ImVec4 style_color(std::uint32_t word, float opacity = 1.0F) {
  ImVec4 result = ImGui::ColorConvertU32ToFloat4(color(word));
  result.w = opacity;
  return result;
}

glm::vec3 linear(std::uint32_t word) {
  const auto part = [word](unsigned shift) {
    return static_cast<float>(linear_from_srgb((word >> shift & 255U) / 255.0));
  };
  return {part(16), part(8), part(0)};
}

struct Shades {
  std::uint32_t window, panel, field, field_hovered, field_active, line, text, faint_text, accent;
};

constexpr Shades dark_shades = {0x15181D, 0x1D2127, 0x2C323B, 0x3A424E, 0x4A5462,
                                0x3D4550, 0xECEFF3, 0xA3ACB8, 0x2F7FC1};
constexpr Shades light_shades = {0xE6E9ED, 0xF7F8FA, 0xE1E5EA, 0xD1D8E0, 0xBCC6D1,
                                 0xC3CAD3, 0x14181D, 0x535C68, 0x8FC4EE};

const Shades& shades_of(Theme theme) { return theme == Theme::dark ? dark_shades : light_shades; }

constexpr std::array font_folders = {"/usr/share/fonts/truetype/dejavu",
                                     "/usr/share/fonts/dejavu-sans-fonts",
                                     "/usr/share/fonts/dejavu-sans-mono-fonts",
                                     "/usr/share/fonts/TTF",
                                     "/usr/share/fonts/dejavu",
                                     "/Library/Fonts",
                                     "/opt/homebrew/share/fonts"};

/// The letters that the viewer uses: European, Greek, arrows, signs of mathematics, shapes and ticks.
constexpr std::array<ImWchar, 21> ranges = {0x20,   0xFF,   0x100,  0x17F,  0x370,  0x3FF,  0x2010,
                                            0x2027, 0x2070, 0x209F, 0x2190, 0x21FF, 0x2200, 0x22FF,
                                            0x2308, 0x230B, 0x25A0, 0x25FF, 0x2713, 0x2718, 0};
/// Those of headings and code.
constexpr std::array<ImWchar, 5> few_ranges = {0x20, 0x17F, 0x2010, 0x2027, 0};

/// The font in `file`, `pixels` high; null where it is not installed.
ImFont* load_font(const char* file, float pixels, const ImWchar* letters) {
  for (const char* folder : font_folders) {
    const std::string path = std::string(folder) + "/" + file;
    std::error_code ignored;
    if (!std::filesystem::exists(path, ignored)) continue;
    ImFontConfig config;
    config.OversampleH = 2;
    config.OversampleV = 1;
    ImFont* font = ImGui::GetIO().Fonts->AddFontFromFileTTF(path.c_str(), pixels, &config, letters);
    if (font != nullptr) return font;
  }
  return nullptr;
}

}  // namespace

Palette palette_of(Theme theme) {
  const Shades& shades = shades_of(theme);
  const bool dark = theme == Theme::dark;
  Palette palette{};
  palette.text = color(shades.text);
  palette.faint_text = color(shades.faint_text);
  palette.canvas = color(shades.window);
  palette.line = color(shades.line);
  palette.good = color(dark ? 0x2FC79A : 0x00704F);
  palette.bad = color(dark ? 0xFF7A33 : 0xB84700);
  palette.warn = color(dark ? okabe_ito::yellow : 0x7A6A00);
  palette.accent = color(dark ? okabe_ito::sky_blue : 0x005A94);
  palette.first = color(dark ? okabe_ito::orange : 0x9A6300);
  palette.second = color(dark ? okabe_ito::sky_blue : okabe_ito::blue);
  palette.backdrop = linear(dark ? 0x2A2F37 : 0xEEEEEE);
  return palette;
}

void apply_style(Theme theme, float em, bool lecture) {
  const Shades& shades = shades_of(theme);
  ImGuiStyle& style = ImGui::GetStyle();
  style = ImGuiStyle();
  if (theme == Theme::dark) {
    ImGui::StyleColorsDark(&style);
  } else {
    ImGui::StyleColorsLight(&style);
  }
  style.WindowRounding = 0.0F;
  style.FrameRounding = 4.0F;
  style.GrabRounding = 4.0F;
  style.WindowBorderSize = 0.0F;
  style.FramePadding = {6.0F, 4.0F};
  style.ItemSpacing = {7.0F, 6.0F};
  style.WindowPadding = {10.0F, 9.0F};
  style.ScrollbarSize = 13.0F;
  style.ScaleAllSizes(em / 16.0F);
  style.FrameBorderSize = lecture ? 2.0F : 1.0F;
  ImVec4* colors = style.Colors;
  colors[ImGuiCol_WindowBg] = style_color(shades.panel);
  colors[ImGuiCol_ChildBg] = style_color(shades.panel, 0.0F);
  colors[ImGuiCol_PopupBg] = style_color(shades.panel);
  colors[ImGuiCol_Text] = style_color(shades.text);
  colors[ImGuiCol_TextDisabled] = style_color(shades.faint_text);
  colors[ImGuiCol_Border] = style_color(shades.line);
  colors[ImGuiCol_Separator] = style_color(shades.line);
  colors[ImGuiCol_FrameBg] = style_color(shades.field);
  colors[ImGuiCol_FrameBgHovered] = style_color(shades.field_hovered);
  colors[ImGuiCol_FrameBgActive] = style_color(shades.field_active);
  colors[ImGuiCol_Button] = style_color(shades.field);
  colors[ImGuiCol_ButtonHovered] = style_color(shades.field_hovered);
  colors[ImGuiCol_ButtonActive] = style_color(shades.field_active);
  colors[ImGuiCol_Header] = style_color(shades.field);
  colors[ImGuiCol_HeaderHovered] = style_color(shades.field_hovered);
  colors[ImGuiCol_HeaderActive] = style_color(shades.field_active);
  colors[ImGuiCol_SliderGrab] = style_color(shades.accent);
  colors[ImGuiCol_SliderGrabActive] = style_color(shades.accent);
  colors[ImGuiCol_CheckMark] = style_color(theme == Theme::dark ? 0x56B4E9U : 0x005A94U);
  colors[ImGuiCol_PlotHistogram] = style_color(shades.accent);
  colors[ImGuiCol_TableHeaderBg] = style_color(shades.field);
  colors[ImGuiCol_TableBorderLight] = style_color(shades.line);
  colors[ImGuiCol_TableBorderStrong] = style_color(shades.line);
  colors[ImGuiCol_TableRowBgAlt] = style_color(shades.field, 0.35F);
}

Fonts load_fonts(float em) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  atlas.Clear();
  const float pixels = std::round(em);
  Fonts fonts;
  fonts.plain = load_font("DejaVuSans.ttf", pixels, ranges.data());
  if (fonts.plain == nullptr) {
    ImFontConfig config;
    config.SizePixels = std::max(13.0F, 13.0F * std::floor(pixels / 13.0F));  // drawn by hand for 13 pixels
    fonts.plain = atlas.AddFontDefault(&config);
  }
  constexpr float heading_size = 1.2F;
  fonts.strong = load_font("DejaVuSans-Bold.ttf", pixels, few_ranges.data());
  fonts.heading = load_font("DejaVuSans-Bold.ttf", std::round(heading_size * pixels), few_ranges.data());
  fonts.code = load_font("DejaVuSansMono.ttf", std::round(0.95F * pixels), few_ranges.data());
  for (ImFont** font : {&fonts.strong, &fonts.heading, &fonts.code}) {
    if (*font == nullptr) *font = fonts.plain;
  }
  atlas.Build();
  return fonts;
}

}  // namespace hsr::window
