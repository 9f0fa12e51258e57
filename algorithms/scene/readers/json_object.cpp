#include "scene/readers/json_object.h"

#include <cmath>

namespace hsr {

using nlohmann::json;

namespace {

const json& empty_object() {
  static const json empty = json::object();
  return empty;
}

/// Deeper nesting than any glTF file has, so that JSON cannot grow without end from a few bytes.
constexpr int greatest_depth = 100;

}  // namespace

json parse_json(const Input& input, std::string_view text) {
  const auto bound_depth = [&](int depth, json::parse_event_t /*event*/, json& /*parsed*/) {
    if (depth > greatest_depth) {
      input.fail({}, "JSON nested more than " + std::to_string(greatest_depth) + " deep");
    }
    return true;
  };
  try {
    return json::parse(text.begin(), text.end(), bound_depth);
  } catch (const json::parse_error& error) {
    const auto offset = static_cast<std::uint64_t>(text.data() - input.bytes.data());
    input.fail(Place::byte(offset + error.byte), "broken JSON");
  } catch (const json::out_of_range&) {  // of which the library does not say where
    input.fail({}, "the JSON holds a number beyond the range of double");
  }
}

JsonObject::JsonObject(const Input& input, const json& value, std::string path)
    : input_(input), value_(value), path_(std::move(path)) {
  if (!value.is_object()) {
    fail("must be an object");
  }
}

void JsonObject::fail(std::string_view what_is_wrong) const {
  input_.fail({}, (path_.empty() ? std::string("the file") : path_) + " " + std::string(what_is_wrong));
}

void JsonObject::fail_at(const char* key, std::string_view what_is_wrong) const {
  input_.fail({}, (path_.empty() ? "" : path_ + ".") + key + " " + std::string(what_is_wrong));
}

const json* JsonObject::find(const char* key) const {
  const auto found = value_.find(key);
  return found == value_.end() ? nullptr : &*found;
}

const json* JsonObject::find_array(const char* key) const {
  const json* array = find(key);
  if (array != nullptr && !array->is_array()) {
    fail_at(key, "must be an array");
  }
  return array;
}

std::uint64_t JsonObject::as_whole(const json& value, const char* key) const {
  constexpr double greatest = 9007199254740992.0;  // 2^53: all whole numbers up to it are doubles
  const double number = value.is_number() ? value.get<double>() : -1.0;
  if (!(number >= 0.0 && number <= greatest) || number != std::floor(number)) {
    fail_at(key, "must be a whole number from 0");
  }
  return static_cast<std::uint64_t>(number);
}

std::uint32_t JsonObject::as_index(const json& value, const char* key, std::size_t size,
                                   std::string_view what) const {
  const std::uint64_t index = as_whole(value, key);
  if (index >= size || index > UINT32_MAX) {
    fail_at(key, "is " + std::to_string(index) + ", but there are only " + std::to_string(size) + " " +
                     std::string(what));
  }
  return static_cast<std::uint32_t>(index);
}

std::uint64_t JsonObject::whole(const char* key, std::uint64_t fallback) const {
  const json* value = find(key);
  return value == nullptr ? fallback : as_whole(*value, key);
}

std::uint64_t JsonObject::need_whole(const char* key) const {
  if (!has(key)) {
    fail_at(key, "is missing");
  }
  return whole(key, 0);
}

std::optional<std::uint32_t> JsonObject::index(const char* key, std::size_t size,
                                               std::string_view what) const {
  const json* value = find(key);
  return value == nullptr ? std::nullopt : std::optional(as_index(*value, key, size, what));
}

std::uint32_t JsonObject::need_index(const char* key, std::size_t size, std::string_view what) const {
  const std::optional<std::uint32_t> found = index(key, size, what);
  if (!found) {
    fail_at(key, "is missing");
  }
  return *found;
}

double JsonObject::number(const char* key, double fallback) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_number()) {
    fail_at(key, "must be a number");
  }
  return value == nullptr ? fallback : value->get<double>();
}

bool JsonObject::flag(const char* key, bool fallback) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_boolean()) {
    fail_at(key, "must be true or false");
  }
  return value == nullptr ? fallback : value->get<bool>();
}

std::string JsonObject::text(const char* key, const std::string& fallback) const {
  const json* value = find(key);
  if (value != nullptr && !value->is_string()) {
    fail_at(key, "must be text");
  }
  return value == nullptr ? fallback : value->get<std::string>();
}

bool JsonObject::numbers(const char* key, std::span<double> values) const {
  const json* array = find_array(key);
  if (array == nullptr) {
    return false;
  }
  if (array->size() != values.size()) {
    fail_at(key, "must be " + std::to_string(values.size()) + " numbers");
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!(*array)[i].is_number()) {
      fail_at(key, "must be " + std::to_string(values.size()) + " numbers");
    }
    values[i] = (*array)[i].get<double>();
  }
  return true;
}

JsonObject JsonObject::object(const char* key) const {
  const json* value = find(key);
  return {input_, value == nullptr ? empty_object() : *value, path_.empty() ? key : path_ + "." + key};
}

void JsonObject::each(const char* key, const std::function<void(const JsonObject&)>& visit) const {
  const json* array = find_array(key);
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    visit({input_, (*array)[i], (path_.empty() ? "" : path_ + ".") + key + "[" + std::to_string(i) + "]"});
  }
}

void JsonObject::each_index(const char* key, std::size_t size, std::string_view what,
                            const std::function<void(std::uint32_t)>& visit) const {
  const json* array = find_array(key);
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    visit(as_index((*array)[i], key, size, what));
  }
}

void JsonObject::each_text(const char* key, const std::function<void(const std::string&)>& visit) const {
  const json* array = find_array(key);
  for (std::size_t i = 0; array != nullptr && i < array->size(); ++i) {
    if (!(*array)[i].is_string()) {
      fail_at(key, "must be an array of texts");
    }
    visit((*array)[i].get<std::string>());
  }
}

}  // namespace hsr
