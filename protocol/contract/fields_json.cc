#include "protocol/contract/fields_json.h"

#include <fmt/format.h>

#include <iterator>

#include "base/overloaded.h"
#include "base/utf8.h"

namespace stanok::protocol {
namespace {

using nlohmann::ordered_json;

ordered_json value_json(const FieldValue& value) {
  return std::visit(Overloaded{[](std::monostate) { return ordered_json(nullptr); },
                               [](const FieldList& list) { return list_json(list); },
                               [](const Fields& fields) { return fields_json(fields); },
                               [](const auto& one) { return ordered_json(one); }},
                    value);
}

// Quotes, backslashes and control characters escaped.
void append_text(std::string& text, std::string_view value) {
  text += '"';
  for (const char c : valid_utf8(value)) {
    if (c == '"' || c == '\\') {
      text += '\\';
      text += c;
    } else if (static_cast<unsigned char>(c) < ' ') {
      fmt::format_to(std::back_inserter(text), "\\u{:04x}", static_cast<unsigned>(c));
    } else {
      text += c;
    }
  }
  text += '"';
}

struct Appended {
  std::string& text;

  void operator()(std::monostate) const { text += "null"; }
  void operator()(const std::string& value) const { append_text(text, value); }
  void operator()(const FieldList& list) const {
    const char* separator = "[";
    for (const FieldValue& value : list) {
      text += separator;
      std::visit(*this, value);
      separator = ",";
    }
    text += list.empty() ? "[]" : "]";
  }
  void operator()(const Fields& fields) const {
    const char* separator = "{";
    for (const Field& field : fields) {
      text += separator;
      append_text(text, field.name);
      text += ':';
      std::visit(*this, field.value);
      separator = ",";
    }
    text += fields.empty() ? "{}" : "}";
  }
  template <class Number>
  void operator()(Number number) const {
    fmt::format_to(std::back_inserter(text), "{}", number);
  }
};

}  // namespace

ordered_json fields_json(const Fields& fields) {
  ordered_json json = ordered_json::object();
  for (const Field& field : fields) json[field.name] = value_json(field.value);
  return json;
}

ordered_json list_json(const FieldList& list) {
  ordered_json json = ordered_json::array();
  for (const FieldValue& value : list) json.push_back(value_json(value));
  return json;
}

void append_json_line(std::string& text, const Fields& fields) {
  Appended{text}(fields);
  text += '\n';
}

}  // namespace stanok::protocol
