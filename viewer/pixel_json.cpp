#include <nlohmann/json.hpp>

#include "pixel_text.h"
#include "scene/atomic_file.h"
#include "trace/event_json.h"
#include "trace/sentences.h"

namespace hsr {
namespace {

using Json = nlohmann::ordered_json;

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

Json color_json(const glm::vec4& color) { return {color.r, color.g, color.b, color.a}; }

Json id_json(std::uint32_t id) { return id == background_id ? Json() : Json(id); }

Json fragment_json(const Scene& scene, const exact::Fragment& fragment, std::size_t rank, bool front) {
  const Triangle& triangle = scene.triangles[fragment.id];
  const bool plain = triangle.material == no_material;
  return {{"rank", rank},
          {"id", fragment.id},
          {"face", triangle.face},
          {"depth", fragment.depth},
          {"opacity", plain ? 1.0F : scene.materials[triangle.material].opacity},
          {"facing", front ? "front" : "back"},
          {"tied", fragment.tied}};
}

/// Writes `,"name":[` ... `]` with a line for each of the items.
template <class Item>
void write_array(OutputFile& output, const char* name, std::size_t size, Item item) {
  output.write(std::string(",\n\"") + name + "\":[");
  for (std::size_t k = 0; k < size; ++k) output.write((k == 0 ? "\n" : ",\n") + item(k));
  output.write("]");
}

}  // namespace

void write_json(const PixelStory& story, const View& view, const AlgorithmSpec& algorithm,
                const std::filesystem::path& file) {
  const Json head = {{"scene", view.scene->name},
                     {"algorithm", algorithm.algorithm->name},
                     {"settings", algorithm.settings},
                     {"width", view.width},
                     {"height", view.height},
                     {"x", story.i},
                     {"y", story.j},
                     {"right", story.covered() ? story.admissible(story.id) : story.id == background_id},
                     {"explanation", explanation(view, algorithm, story)},
                     {"answer",
                      {{"id", id_json(story.id)},
                       {"depth", story.id == background_id ? Json() : Json(story.depth)},
                       {"color", color_json(story.color)}}},
                     {"exact",
                      {{"id", story.covered() ? Json(story.list.front().id) : Json()},
                       {"depth", story.covered() ? Json(story.list.front().depth) : Json()},
                       {"color", color_json(story.exact_color)}}},
                     {"departure", story.departure ? Json(story.departure->step) : Json()},
                     {"steps", story.history.total}};
  const std::vector<bool> front = fronts(view, story.list);
  write_file_atomically(file, [&](const std::filesystem::path& temporary) {
    OutputFile output(temporary);
    const std::string begin = dumped(head);
    output.write(begin.substr(0, begin.size() - 1));  // without the closing brace
    write_array(output, "list", story.list.size(), [&](std::size_t k) {
      return dumped(fragment_json(*view.scene, story.list[k], k + 1, front[k]));
    });
    write_array(output, "history", story.history.events.size(), [&](std::size_t k) {
      return to_json_line({story.history.first + k, story.history.events[k]});
    });
    output.write("}\n");
    output.close();
  });
}

}  // namespace hsr
