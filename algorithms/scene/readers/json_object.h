#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "scene/readers/input.h"

namespace hsr {

/// Parses JSON, which is a part of the input's bytes. Throws InputError, with the byte, where it is
/// broken, and on nesting more than 100 deep, of which a few bytes could make a lot of memory.
nlohmann::json parse_json(const Input& input, std::string_view text);

/// A JSON object with the path to it ("nodes[3]"), read with checks: what is missing or of another
/// type than asked for throws InputError with its path.
class JsonObject {
 public:
  JsonObject(const Input& input, const nlohmann::json& value, std::string path);

  bool has(const char* key) const { return value_.contains(key); }

  /// A whole number from 0 to 2^53, or `fallback` where there is none; need_whole must find one.
  std::uint64_t whole(const char* key, std::uint64_t fallback) const;
  std::uint64_t need_whole(const char* key) const;

  /// A whole number below `size` (of the array `what`), or nothing.
  std::optional<std::uint32_t> index(const char* key, std::size_t size, std::string_view what) const;
  std::uint32_t need_index(const char* key, std::size_t size, std::string_view what) const;

  double number(const char* key, double fallback) const;
  bool flag(const char* key, bool fallback) const;
  std::string text(const char* key, const std::string& fallback) const;

  /// Fills `values` with an array of as many numbers. Returns false if there is none.
  bool numbers(const char* key, std::span<double> values) const;

  /// The object under a key, empty if there is none.
  JsonObject object(const char* key) const;

  /// Calls visit for every object of an array; for none if there is no array.
  void each(const char* key, const std::function<void(const JsonObject&)>& visit) const;

  /// Calls visit for every whole number below `size` of an array.
  void each_index(const char* key, std::size_t size, std::string_view what,
                  const std::function<void(std::uint32_t)>& visit) const;

  /// Calls visit for every text of an array.
  void each_text(const char* key, const std::function<void(const std::string&)>& visit) const;

  [[noreturn]] void fail(std::string_view what_is_wrong) const;

 private:
  [[noreturn]] void fail_at(const char* key, std::string_view what_is_wrong) const;
  const nlohmann::json* find(const char* key) const;
  const nlohmann::json* find_array(const char* key) const;
  std::uint64_t as_whole(const nlohmann::json& value, const char* key) const;
  std::uint32_t as_index(const nlohmann::json& value, const char* key, std::size_t size,
                         std::string_view what) const;

  const Input& input_;
  const nlohmann::json& value_;
  std::string path_;
};

}  // namespace hsr
