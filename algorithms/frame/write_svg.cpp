#include "frame/write_svg.h"

#include <array>
#include <cstddef>
#include <cstdio>
#include <string>

#include "frame/srgb.h"
#include "scene/atomic_file.h"

namespace hsr {
namespace {

template <class... Values>
void append(std::string& text, const char* format, Values... values) {
  std::array<char, 160> piece{};
  const int size = std::snprintf(piece.data(), piece.size(), format, values...);
  text.append(piece.data(), static_cast<std::size_t>(size));
}

void append_color(std::string& text, const glm::vec3& linear) {
  append(text, "#%02x%02x%02x", srgb8_from_linear(double{linear.r}), srgb8_from_linear(double{linear.g}),
         srgb8_from_linear(double{linear.b}));
}

void append_face(std::string& text, const PaintedFace& face) {
  append(text, "<polygon id=\"t%u", face.triangles.front());
  if (face.piece != 0) append(text, "-%u", face.piece);
  text += "\" data-triangles=\"";
  for (const std::uint32_t id : face.triangles) append(text, id == face.triangles.front() ? "%u" : " %u", id);
  text += "\" fill=\"";
  const float opacity = face.color.a;
  append_color(text, opacity > 0.0F ? glm::vec3(face.color) / opacity : glm::vec3(0.0F));
  if (opacity < 1.0F) append(text, "\" fill-opacity=\"%.6g", double{opacity});
  text += "\" points=\"";
  const char* separator = "";
  for (const glm::dvec2& corner : face.outline) {
    append(text, "%s%.6f,%.6f", separator, corner.x, corner.y);
    separator = " ";
  }
  text += "\"/>\n";
}

}  // namespace

void write_svg(const std::vector<PaintedFace>& faces, int width, int height, const glm::vec3& backdrop,
               const std::filesystem::path& file, const Progress& progress) {
  constexpr std::size_t report_every = 4096;
  std::string text;
  append(text,
         "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%d\" height=\"%d\" viewBox=\"0 0 %d %d\" "
         "shape-rendering=\"crispEdges\" color-interpolation=\"linearRGB\">\n",
         width, height, width, height);
  append(text, "<rect width=\"%d\" height=\"%d\" fill=\"", width, height);
  append_color(text, backdrop);
  text += "\"/>\n";
  for (std::size_t place = 0; place < faces.size(); ++place) {
    append_face(text, faces[place]);
    if (place % report_every == 0) {
      (void)report_progress(progress, "writing the faces",
                            static_cast<double>(place) / static_cast<double>(faces.size()));
    }
  }
  text += "</svg>\n";
  write_file_atomically(file, [&](const std::filesystem::path& temporary) { write_bytes(temporary, text); });
}

}  // namespace hsr
