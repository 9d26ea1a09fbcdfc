// Fields: a result by the names of its values, in their order, as every face shows it: terminal,
// protocol, Python.
//
//   const Fields cut{{"speed_rev_per_min", 9000.0}, {"stable", true}};
//
// Values are truths, whole numbers, numbers, texts, lists, and fields again; none (std::monostate)
// where a value is not known. A number with a unit has it at the end of its name. How all of it is
// written is the matter of a face (protocol/contract/fields_json.h).
#pragma once

#include <concepts>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace stanok {

struct Field;
struct FieldValue;
using Fields = std::vector<Field>;
using FieldList = std::vector<FieldValue>;

struct FieldValue
    : std::variant<std::monostate, bool, std::int64_t, double, std::string, FieldList, Fields> {
  using variant::variant;
};

struct Field {
  std::string name;
  FieldValue value;
};

[[nodiscard]] inline FieldValue text_field(std::string_view text) {
  return std::string(text);
}
// Of any kind of whole number, which must be below 2^63.
[[nodiscard]] FieldValue count_field(std::integral auto count) {
  return static_cast<std::int64_t>(count);
}
[[nodiscard]] inline FieldValue optional_field(const std::optional<double>& value) {
  return value ? FieldValue(*value) : FieldValue();
}

// A list of what `field` makes of each value of a range.
template <class Range, class MakeField>
[[nodiscard]] FieldList field_list(const Range& range, MakeField field) {
  FieldList list;
  for (const auto& value : range) list.emplace_back(field(value));
  return list;
}
// A list of numbers.
template <class Range>
[[nodiscard]] FieldList number_list(const Range& numbers) {
  return field_list(numbers, [](double number) { return number; });
}

}  // namespace stanok
