// Declarative key tables: one row per key of a TOML table gives its name, place in the struct,
// presence, unit, allowed values and meaning.
//
//   const Keys<Spindle> spindle_keys = {
//       {"id", at<&Spindle::id>, required, "", "number of the spindle", from(1)},
//       {"speed_max", at<&Spindle::speed_max>, required, "rev/min", "highest speed", positive},
//   };
//
// The type of the member is the kind of the key, its initial value the default. read_table fills a
// struct from a TOML table, strictly: unknown keys, missing keys, wrong kinds and values outside
// the range become faults, and reading goes on. describe() gives the same rows to
// docs/reference/configuration.md.
#pragma once

#include <toml++/toml.h>

#include <array>
#include <limits>
#include <map>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/text/fault_list.h"

namespace stanok::config {

// Which values a key may have: a range for numbers, a list of names for texts.
struct Allowed {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  std::vector<std::string_view> names{};  // empty: any text
  bool direction = false;                 // three numbers, read as the unit vector along them
  bool part_of_path = false;              // a text that files and folders are named after
};

inline const Allowed any{};
// Beyond it, in the units of the file, is a slip; sums and quotients of several quantities would
// leave what numbers hold.
inline const Allowed positive{.min = 1e-9, .max = 1e12};
// Of a velocity, acceleration or jerk: what moves less than a micrometre a second stands.
inline const Allowed limit_of_motion{.min = 1e-3, .max = 1e9};
inline const Allowed not_negative{.min = 0.0};
inline const Allowed direction{.direction = true};
inline const Allowed part_of_path{.part_of_path = true};
[[nodiscard]] inline Allowed from(double min,
                                  double max = std::numeric_limits<double>::infinity()) {
  return {.min = min, .max = max};
}
[[nodiscard]] inline Allowed one_of(std::vector<std::string_view> names) {
  return {.names = std::move(names)};
}

enum class Presence { optional, required };
using enum Presence;

// What a key says, whatever struct it fills.
struct KeyText {
  std::string_view name;
  Presence presence = optional;
  std::string_view unit;
  std::string_view meaning;
  Allowed allowed{};
  std::string_view initial{};  // default in words, where it is not the initial value
  std::string_view former{};   // what the key was called in an older version
};

using Numbers3 = std::array<double, 3>;
using Texts = std::vector<std::string>;
using Integers = std::vector<int>;
using TextMap = std::map<std::string, std::string>;
using Subtable = const toml::table*;   // read by its own key table; nullptr: absent
using Subtables = const toml::array*;  // of tables, likewise

// Where the value of a key goes. Each type is a kind of TOML value.
template <class Target>
using Slot = std::variant<double& (*)(Target&), int& (*)(Target&), bool& (*)(Target&),
                          std::string& (*)(Target&), Numbers3& (*)(Target&), Texts& (*)(Target&),
                          Integers& (*)(Target&), TextMap& (*)(Target&), Subtable& (*)(Target&),
                          Subtables& (*)(Target&)>;

template <class Owner, class Member>
Owner owner_of(Member Owner::*);

// at<&A::b, &B::c> is the function that takes an A to its b.c.
template <auto First, auto... Rest>
inline constexpr auto at =
    +[](decltype(owner_of(First))& target) -> auto& { return ((target.*First).*....*Rest); };

template <class Target>
struct Key {
  std::string_view name;
  Slot<Target> slot;
  Presence presence = optional;
  std::string_view unit;
  std::string_view meaning;
  Allowed allowed{};
  std::string_view initial{};
  std::string_view former{};

  [[nodiscard]] KeyText text() const {
    return {name, presence, unit, meaning, allowed, initial, former};
  }
};

template <class Target>
using Keys = std::vector<Key<Target>>;

// What a reader carries along: where faults go, and how the current table is called in them.
struct Scope {
  FaultList& faults;
  std::string name;  // "axis X", "[drives]"

  [[nodiscard]] Scope inner(const std::string& part) const { return {faults, name + ": " + part}; }
  void fault(const toml::source_region& place, const std::string& text) const {
    faults.add(place, name + ": " + text);
  }
};

// A key as a row of the documentation.
struct KeyRow {
  std::string name;
  std::string kind;
  std::string unit;
  std::string initial;  // default; "required"
  std::string allowed;
  std::string meaning;
};

// The place of the value of `key`, or of the table when the key is absent.
[[nodiscard]] const toml::source_region& place_of(const toml::table& table, std::string_view key);

// The place of element `index` of the list `key`.
[[nodiscard]] const toml::source_region& place_of(const toml::table& table, std::string_view key,
                                                  std::size_t index);

// A number as a person writes it: the shortest text that reads back to the same bits.
[[nodiscard]] std::string number_text(double value);

// A text in quotes for a message, in one line.
[[nodiscard]] std::string quoted(std::string_view text);

// Faults for keys of `table` that are not in `known`, with the nearest known one.
void refuse_unknown_keys(const toml::table& table, const std::vector<std::string_view>& known,
                         const Scope& scope);

namespace detail {

void read_value(const toml::node&, const KeyText&, const Scope&, double& value);
void read_value(const toml::node&, const KeyText&, const Scope&, int& value);
void read_value(const toml::node&, const KeyText&, const Scope&, bool& value);
void read_value(const toml::node&, const KeyText&, const Scope&, std::string& value);
void read_value(const toml::node&, const KeyText&, const Scope&, Numbers3& value);
void read_value(const toml::node&, const KeyText&, const Scope&, Texts& value);
void read_value(const toml::node&, const KeyText&, const Scope&, Integers& value);
void read_value(const toml::node&, const KeyText&, const Scope&, TextMap& value);
void read_value(const toml::node&, const KeyText&, const Scope&, Subtable& value);
void read_value(const toml::node&, const KeyText&, const Scope&, Subtables& value);

void missing_key(const toml::table&, const KeyText&, const Scope&);
// A fault where the table has the key by its former name.
void refuse_former_name(const toml::table&, const KeyText&, const Scope&);

// Kind and default of a member, for the documentation.
struct KindText {
  std::string kind;
  std::string initial;
};
KindText kind_text(double value);
KindText kind_text(int value);
KindText kind_text(bool value);
KindText kind_text(const std::string& value);
KindText kind_text(const Numbers3& value);
KindText kind_text(const Texts& value);
KindText kind_text(const Integers& value);
KindText kind_text(const TextMap& value);
KindText kind_text(Subtable value);
KindText kind_text(Subtables value);

KeyRow key_row(const KeyText& key, const KindText& kind);

}  // namespace detail

// Fills `target` from `table`. What is at fault keeps its initial value; keys that are not in
// `keys` are not looked at.
template <class Target>
void read_keys(const toml::table& table, const Keys<Target>& keys, Target& target,
               const Scope& scope) {
  for (const Key<Target>& key : keys) {
    const toml::node* node = table.get(key.name);
    if (node == nullptr) {
      if (key.presence == required) detail::missing_key(table, key.text(), scope);
      continue;
    }
    std::visit([&](auto slot) { detail::read_value(*node, key.text(), scope, slot(target)); },
               key.slot);
  }
}

// The same for a table that may have no other keys.
template <class Target>
void read_table(const toml::table& table, const Keys<Target>& keys, Target& target,
                const Scope& scope) {
  read_keys(table, keys, target, scope);
  std::vector<std::string_view> names;
  for (const Key<Target>& key : keys) {
    names.push_back(key.name);
    if (key.former.empty()) continue;
    names.push_back(key.former);
    detail::refuse_former_name(table, key.text(), scope);
  }
  refuse_unknown_keys(table, names, scope);
}

// The rows of a key table, with the defaults of a new Target.
template <class Target>
[[nodiscard]] std::vector<KeyRow> describe(const Keys<Target>& keys) {
  std::vector<KeyRow> rows;
  Target initial{};
  for (const Key<Target>& key : keys) {
    const auto kind =
        std::visit([&](auto slot) { return detail::kind_text(slot(initial)); }, key.slot);
    rows.push_back(detail::key_row(key.text(), kind));
  }
  return rows;
}

}  // namespace stanok::config
