#include "window/script/values.h"

#include <algorithm>
#include <array>

#include "nearest_name.h"
#include "scene/errors.h"
#include "trace/event_json.h"

namespace hsr::window {
namespace {

struct NamedValue {
  std::string_view name;
  ScriptValue (*get)(const Session&);
};

template <class Pointer>
Pointer require(Pointer pointer, const char* what) {
  if (!pointer) throw InputError(std::string("there is no ") + what);
  return pointer;
}

double number(std::uint64_t value) { return static_cast<double>(value); }

const exact::Errors& errors_of(const Session& session) {
  return require(session.bench.judgement(), "comparison with the exact answer")->errors;
}

glm::ivec2 pixel_of(const Session& session) {
  const auto pixel = session.pixel_in_question();
  if (!pixel) throw InputError("no pixel is selected");
  return *pixel;
}

const Frame& frame_of(const Session& session) { return require(session.bench.picture(), "picture")->frame; }

std::size_t index_of(const Session& session) {
  const glm::ivec2 pixel = pixel_of(session);
  const Frame& frame = frame_of(session);
  if (pixel.x >= frame.width || pixel.y >= frame.height) throw InputError("the pixel is not in the picture");
  return frame.index(pixel.x, pixel.y);
}

const std::array values = {
    NamedValue{"scene", [](const Session& s) -> ScriptValue { return s.bench.state.scene; }},
    NamedValue{"algorithm", [](const Session& s) -> ScriptValue { return s.bench.state.algorithm.text(); }},
    NamedValue{"maker", [](const Session& s) -> ScriptValue { return s.bench.maker_name(); }},
    NamedValue{"compare",
               [](const Session& s) -> ScriptValue {
                 return std::string(comparing_names()[static_cast<std::size_t>(s.bench.state.comparing)]);
               }},
    NamedValue{"other", [](const Session& s) -> ScriptValue { return s.bench.other_name(); }},
    NamedValue{"overlay",
               [](const Session& s) -> ScriptValue {
                 return std::string(overlay_names()[static_cast<std::size_t>(s.bench.state.overlay)]);
               }},
    NamedValue{"theme",
               [](const Session& s) -> ScriptValue {
                 return std::string(theme_names()[static_cast<std::size_t>(s.bench.state.theme)]);
               }},
    NamedValue{"triangles",
               [](const Session& s) -> ScriptValue {
                 return number(require(s.bench.model(), "scene")->scene->triangles.size());
               }},
    NamedValue{"wrong", [](const Session& s) -> ScriptValue { return number(errors_of(s).wrong); }},
    NamedValue{"holes", [](const Session& s) -> ScriptValue { return number(errors_of(s).holes); }},
    NamedValue{"leaks", [](const Session& s) -> ScriptValue { return number(errors_of(s).leaks); }},
    NamedValue{"wrong-blends",
               [](const Session& s) -> ScriptValue {
                 (void)errors_of(s);
                 const auto causes = s.bench.causes();
                 return causes ? number(causes->of(Cause::transparency_unsorted)) : 0.0;
               }},
    NamedValue{"width", [](const Session& s) -> ScriptValue { return double(s.bench.picture_size().width); }},
    NamedValue{"height",
               [](const Session& s) -> ScriptValue { return double(s.bench.picture_size().height); }},
    NamedValue{"x", [](const Session& s) -> ScriptValue { return double(pixel_of(s).x); }},
    NamedValue{"y", [](const Session& s) -> ScriptValue { return double(pixel_of(s).y); }},
    NamedValue{"id", [](const Session& s) -> ScriptValue { return number(frame_of(s).id[index_of(s)]); }},
    NamedValue{"depth",
               [](const Session& s) -> ScriptValue { return double(frame_of(s).depth[index_of(s)]); }},
    NamedValue{"wiper", [](const Session& s) -> ScriptValue { return double(s.bench.state.wiper); }},
    NamedValue{"magnification",
               [](const Session& s) -> ScriptValue { return double(s.bench.state.magnification); }},
    NamedValue{"lecture", [](const Session& s) -> ScriptValue { return s.bench.state.lecture ? 1.0 : 0.0; }},
    NamedValue{"scale", [](const Session& s) -> ScriptValue { return double(s.bench.state.scale); }},
    NamedValue{"eye.x", [](const Session& s) -> ScriptValue { return s.bench.camera().eye.x; }},
    NamedValue{"eye.y", [](const Session& s) -> ScriptValue { return s.bench.camera().eye.y; }},
    NamedValue{"eye.z", [](const Session& s) -> ScriptValue { return s.bench.camera().eye.z; }},
    NamedValue{"frame-ms", [](const Session& s) -> ScriptValue { return s.frame_times.quantile(1.0); }},
    NamedValue{"frame-ms-99", [](const Session& s) -> ScriptValue { return s.frame_times.quantile(0.99); }},
    NamedValue{"frame-ms-median", [](const Session& s) -> ScriptValue { return s.frame_times.quantile(0.5); }},
    NamedValue{"window.width",
               [](const Session& s) -> ScriptValue {
                 return s.bench.state.window ? double(s.bench.state.window->width) : 0.0;
               }},
    NamedValue{"frames", [](const Session& s) -> ScriptValue { return double(s.frame_times.count()); }},
    NamedValue{"picture-ms",
               [](const Session& s) -> ScriptValue { return require(s.bench.picture(), "picture")->render_ms; }},
    NamedValue{"build-ms",
               [](const Session& s) -> ScriptValue { return require(s.bench.picture(), "picture")->prepare_ms; }},
    NamedValue{"boxes",
               [](const Session& s) -> ScriptValue {
                 const auto structure = require(s.bench.structure(), "structure");
                 return double(structure->nodes.size() + structure->cells.size());
               }},
    NamedValue{"step-ms",
               [](const Session& s) -> ScriptValue { return require(s.bench.moment(), "step")->milliseconds; }},
    NamedValue{"visited",
               [](const Session& s) -> ScriptValue { return double(require(s.bench.moment(), "step")->visited.size()); }},
    NamedValue{"in-list",
               [](const Session& s) -> ScriptValue { return double(require(s.bench.moment(), "step")->list.size()); }},
    NamedValue{"in-order",
               [](const Session& s) -> ScriptValue { return double(require(s.bench.moment(), "step")->order.size()); }},
    NamedValue{"kind",
               [](const Session& s) -> ScriptValue {
                 const auto moment = require(s.bench.moment(), "step");
                 return moment->event ? std::string(event_name(moment->event->kind)) : std::string();
               }},
    NamedValue{"skips-measured",
               [](const Session& s) -> ScriptValue {
                 return double(require(s.bench.skip_times(), "measurement of skips")->saved.size());
               }},
    NamedValue{"lesson", [](const Session& s) -> ScriptValue { return double(s.bench.state.lesson); }},
    NamedValue{"lesson step", [](const Session& s) -> ScriptValue { return double(s.bench.state.lesson_step); }},
    NamedValue{"step", [](const Session& s) -> ScriptValue { return number(s.bench.state.step); }},
    NamedValue{
        "steps",
        [](const Session& s) -> ScriptValue { return number(require(s.bench.trace(), "trace")->total); }},
    NamedValue{"departure",
               [](const Session& s) -> ScriptValue {
                 const auto marks = require(s.bench.marks(), "check of the steps");
                 return marks->departure ? number(*marks->departure) : 0.0;
               }},
    NamedValue{"fragments",
               [](const Session& s) -> ScriptValue {
                 return number(require(s.bench.story(), "story of the pixel")->pixel.list.size());
               }},
    NamedValue{"pixel-ms",
               [](const Session& s) -> ScriptValue {
                 return require(s.bench.story(), "story of the pixel")->milliseconds;
               }},
    NamedValue{"problem",
               [](const Session& s) -> ScriptValue {
                 const auto problems = s.bench.problems();
                 return problems.empty() ? std::string() : problems.front();
               }},
    NamedValue{"pictures", [](const Session& s) -> ScriptValue { return number(s.bench.pictures_made()); }},
};

}  // namespace

std::vector<std::string_view> script_value_names() {
  std::vector<std::string_view> names;
  for (const NamedValue& value : values) names.push_back(value.name);
  return names;
}

ScriptValue script_value(const Session& session, std::string_view name) {
  const auto found = std::ranges::find(values, name, &NamedValue::name);
  if (found == values.end()) {
    throw UsageError("unknown value \"" + std::string(name) + "\"" +
                     what_there_is(name, script_value_names()));
  }
  return found->get(session);
}

}  // namespace hsr::window
