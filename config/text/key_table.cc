// Reading of single values against their row of a key table, and the wording of faults.
#include "config/text/key_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/nearest_name.h"

namespace stanok::config {
namespace {

constexpr std::size_t path_part_max = 64;  // bytes; of a path to a socket there are 107

bool is_control(char c) {
  const auto code = static_cast<unsigned char>(c);
  return code < 0x20 || code == 0x7f;
}

std::string joined(const std::vector<std::string_view>& names, std::string_view separator) {
  std::string text;
  for (const std::string_view name : names) {
    if (!text.empty()) text += separator;
    text += name;
  }
  return text;
}

std::string_view kind_of_node(const toml::node& node) {
  switch (node.type()) {
    case toml::node_type::table:
      return "a table";
    case toml::node_type::array:
      return "a list";
    case toml::node_type::string:
      return "a text";
    case toml::node_type::integer:
      return "an integer";
    case toml::node_type::floating_point:
      return "a number";
    case toml::node_type::boolean:
      return "true or false";
    default:
      return "a date or time";
  }
}

// "its meaning in unit", as the remedy of a fault.
std::string explained(const KeyText& key) {
  std::string text(key.meaning);
  if (!key.unit.empty()) text += ", " + std::string(key.unit);
  return text;
}

void wrong_kind(const toml::node& node, const KeyText& key, const Scope& scope,
                std::string_view wanted) {
  scope.fault(node.source(), std::string(key.name) + " is " + std::string(kind_of_node(node)) +
                                 "; write " + std::string(wanted) + " (" + explained(key) + ")");
}

std::string range_text(const Allowed& allowed) {
  const bool has_min = std::isfinite(allowed.min);
  const bool has_max = std::isfinite(allowed.max);
  if (has_min && has_max) return number_text(allowed.min) + " to " + number_text(allowed.max);
  if (has_min) return number_text(allowed.min) + " or more";
  if (has_max) return number_text(allowed.max) + " or less";
  if (allowed.part_of_path) {
    return "1 to " + std::to_string(path_part_max) +
           " bytes, no '/', no '.' or blank at its beginning";
  }
  return allowed.direction ? "not 0, 0, 0" : "";
}

bool is_allowed(const toml::node& node, const KeyText& key, const Scope& scope, double value) {
  const Allowed& allowed = key.allowed;
  if (allowed.min <= value && value <= allowed.max) return true;
  scope.fault(node.source(), std::string(key.name) + " is " + number_text(value) + "; it must be " +
                                 range_text(allowed) + " (" + explained(key) + ")");
  return false;
}

// A finite number; nothing, and a fault, when the node is another kind.
std::optional<double> number(const toml::node& node, const KeyText& key, const Scope& scope,
                             std::string_view wanted) {
  const std::optional<double> value =
      node.is_number() ? node.value<double>() : std::optional<double>();
  if (!value) {
    wrong_kind(node, key, scope, wanted);
  } else if (!std::isfinite(*value)) {
    scope.fault(node.source(),
                std::string(key.name) + " is not finite; write a number (" + explained(key) + ")");
    return std::nullopt;
  }
  return value;
}

// Texts come into messages, file names and the bus: none may break a line or steer a terminal.
bool is_plain(const toml::node& node, const KeyText& key, const Scope& scope,
              std::string_view text) {
  if (std::ranges::none_of(text, is_control)) return true;
  scope.fault(node.source(), std::string(key.name) + " is " + quoted(text) +
                                 "; write it without control characters");
  return false;
}

bool is_part_of_path(std::string_view text) {
  return !text.empty() && text.size() <= path_part_max && text.front() != '.' &&
         text.front() != ' ' && text.find('/') == std::string_view::npos;
}

// Shortens or lengthens a vector to 1; false when it is zero.
bool make_unit(Numbers3& vector) {
  const double length = std::hypot(vector[0], vector[1], vector[2]);
  if (length == 0.0) return false;
  for (double& component : vector) component /= length;
  return true;
}

std::string list_text(const Numbers3& numbers) {
  return number_text(numbers[0]) + ", " + number_text(numbers[1]) + ", " + number_text(numbers[2]);
}

std::optional<int> integer(const toml::node& node, const KeyText& key, const Scope& scope,
                           std::string_view wanted) {
  if (!node.is_integer()) {
    wrong_kind(node, key, scope, wanted);
    return std::nullopt;
  }
  const std::optional<int> value = node.value<int>();
  if (!value) {
    scope.fault(node.source(), std::string(key.name) +
                                   " is too large; write an integer of at most "
                                   "nine digits (" +
                                   explained(key) + ")");
  }
  return value;
}

}  // namespace

const toml::source_region& place_of(const toml::table& table, std::string_view key) {
  const toml::node* node = table.get(key);
  return node == nullptr ? table.source() : node->source();
}

const toml::source_region& place_of(const toml::table& table, std::string_view key,
                                    std::size_t index) {
  const toml::array* list = table[key].as_array();
  const toml::node* element = list == nullptr ? nullptr : list->get(index);
  return element == nullptr ? place_of(table, key) : element->source();
}

std::string quoted(std::string_view text) {
  std::string line = "'";
  for (const char c : text) line += is_control(c) ? '?' : c;
  return line + '\'';
}

std::string number_text(double value) {
  std::array<char, 32> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  return {text.data(), end};
}

void refuse_unknown_keys(const toml::table& table, const std::vector<std::string_view>& known,
                         const Scope& scope) {
  for (const auto& [key, node] : table) {
    if (std::ranges::find(known, key.str()) != known.end()) continue;
    const std::string_view nearest = nearest_name(key.str(), known);
    scope.fault(key.source(), "unknown key " + quoted(key.str()) +
                                  (nearest.empty() ? "; the keys here are " + joined(known, ", ")
                                                   : "; did you mean " + quoted(nearest) + "?"));
  }
}

namespace detail {

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, double& value) {
  const auto read = number(node, key, scope, "a number");
  if (read && is_allowed(node, key, scope, *read)) value = *read;
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, int& value) {
  const auto read = integer(node, key, scope, "an integer");
  if (read && is_allowed(node, key, scope, *read)) value = *read;
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, bool& value) {
  const auto read = node.value_exact<bool>();
  if (read) {
    value = *read;
  } else {
    wrong_kind(node, key, scope, "true or false");
  }
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope,
                std::string& value) {
  const auto read = node.value_exact<std::string_view>();
  const auto& names = key.allowed.names;
  if (!read) {
    wrong_kind(node, key, scope, names.empty() ? "a text in quotes" : "one of the names in quotes");
  } else if (!names.empty() && std::ranges::find(names, *read) == names.end()) {
    scope.fault(node.source(), std::string(key.name) + " is " + quoted(*read) +
                                   "; it must be one of " + joined(names, ", "));
  } else if (key.presence == required && read->empty()) {
    scope.fault(node.source(),
                std::string(key.name) + " is empty; write the " + std::string(key.meaning));
  } else if (key.allowed.part_of_path && !is_part_of_path(*read)) {
    scope.fault(node.source(), std::string(key.name) + " is " + quoted(*read) + "; it must have " +
                                   range_text(key.allowed) + " (" + explained(key) + ")");
  } else if (is_plain(node, key, scope, *read)) {
    value = *read;
  }
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, Numbers3& value) {
  constexpr std::string_view wanted = "a list of three numbers [x, y, z]";
  const toml::array* list = node.as_array();
  if (list == nullptr || list->size() != 3) return wrong_kind(node, key, scope, wanted);
  Numbers3 numbers{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto read = number(*list->get(k), key, scope, wanted);
    if (!read) return;
    numbers[k] = *read;
  }
  if (key.allowed.direction && !make_unit(numbers)) {
    scope.fault(node.source(), std::string(key.name) + " is " + list_text(numbers) +
                                   "; it must have a direction (" + explained(key) + ")");
    return;
  }
  value = numbers;
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, Texts& value) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return wrong_kind(node, key, scope, "a list of texts in quotes");
  Texts texts;
  for (const toml::node& element : *list) {
    const auto read = element.value_exact<std::string>();
    if (!read) return wrong_kind(element, key, scope, "a list of texts in quotes");
    if (!is_plain(element, key, scope, *read)) return;
    texts.push_back(*read);
  }
  value = std::move(texts);
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, Integers& value) {
  const toml::array* list = node.as_array();
  if (list == nullptr) return wrong_kind(node, key, scope, "a list of integers");
  Integers integers;
  for (const toml::node& element : *list) {
    const auto read = integer(element, key, scope, "a list of integers");
    if (!read) return;
    integers.push_back(*read);
  }
  value = std::move(integers);
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, TextMap& value) {
  const toml::table* table = node.as_table();
  if (table == nullptr) return wrong_kind(node, key, scope, "a table of texts");
  for (const auto& [name, element] : *table) {
    if (const auto read = element.value_exact<std::string>()) {
      if (is_plain(element, key, scope, name.str()) && is_plain(element, key, scope, *read))
        value[std::string(name.str())] = *read;
    } else {
      wrong_kind(element, key, scope, "a text in quotes");
    }
  }
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, Subtable& value) {
  value = node.as_table();
  if (value == nullptr) wrong_kind(node, key, scope, "a table");
}

void read_value(const toml::node& node, const KeyText& key, const Scope& scope, Subtables& value) {
  const toml::array* list = node.as_array();
  const bool of_tables = list != nullptr && std::ranges::all_of(*list, &toml::node::is_table);
  value = of_tables ? list : nullptr;
  if (!of_tables)
    wrong_kind(node, key, scope, "tables, each under [[" + std::string(key.name) + "]]");
}

void refuse_former_name(const toml::table& table, const KeyText& key, const Scope& scope) {
  if (const toml::node* node = table.get(key.former); node != nullptr)
    scope.fault(node->source(), quoted(key.former) + " is called " + quoted(key.name) + " now");
}

void missing_key(const toml::table& table, const KeyText& key, const Scope& scope) {
  scope.fault(table.source(),
              "key " + quoted(key.name) + " is missing; add it (" + explained(key) + ")");
}

KindText kind_text(double value) {
  return {"number", std::isfinite(value) ? number_text(value) : "none"};
}
KindText kind_text(int value) {
  return {"integer", std::to_string(value)};
}
KindText kind_text(bool value) {
  return {"true or false", value ? "true" : "false"};
}
KindText kind_text(const std::string& value) {
  return {"text", value.empty() ? "none" : '"' + value + '"'};
}
KindText kind_text(const Numbers3& value) {
  return {"three numbers", list_text(value)};
}
KindText kind_text(const Texts&) {
  return {"list of texts", "none"};
}
KindText kind_text(const Integers&) {
  return {"list of integers", "none"};
}
KindText kind_text(const TextMap&) {
  return {"table of texts", "none"};
}
KindText kind_text(Subtable) {
  return {"table", "none"};
}
KindText kind_text(Subtables) {
  return {"tables", "none"};
}

KeyRow key_row(const KeyText& key, const KindText& kind) {
  std::string initial = key.initial.empty() ? kind.initial : std::string(key.initial);
  if (key.presence == required) initial = "required";
  return {.name = std::string(key.name),
          .kind = kind.kind,
          .unit = std::string(key.unit),
          .initial = std::move(initial),
          .allowed =
              key.allowed.names.empty() ? range_text(key.allowed) : joined(key.allowed.names, ", "),
          .meaning = std::string(key.meaning)};
}

}  // namespace detail

}  // namespace stanok::config
