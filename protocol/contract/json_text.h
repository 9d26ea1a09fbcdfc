// JSON as text: the one place where values become characters.
//
// Strings of a value may come from files, file names and the system and hold any bytes. What is no
// UTF-8 becomes U+FFFD, so that the text is valid and nothing is thrown.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace stanok::protocol {

enum class JsonLayout { one_line, indented };

// `Json` is nlohmann::json or nlohmann::ordered_json.
template <class Json>
[[nodiscard]] std::string json_text(const Json& value, JsonLayout layout = JsonLayout::one_line) {
  constexpr int dense = -1;
  const int indentation = layout == JsonLayout::indented ? 1 : dense;
  return value.dump(indentation, ' ', false, Json::error_handler_t::replace);
}

}  // namespace stanok::protocol
