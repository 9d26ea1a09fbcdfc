// The names that a C++ text declares at namespace level, for tests of how sources may be joined.
//
// No compiler: it reads texts as tools/format.sh lays them out. Namespaces and what they declare
// begin in the first column, bodies are indented. Operators and members that are defined outside of
// their class are left out, so are using-declarations.
#pragma once

#include <compare>
#include <set>
#include <string>
#include <string_view>

namespace stanok::testing {

struct DeclaredName {
  std::string scope;        // "stanok::lang": the namespaces with names around it
  std::string name;         // of a function, constant, type, alias, template or enumerator
  bool is_unnamed = false;  // in an unnamed namespace

  auto operator<=>(const DeclaredName&) const = default;
};

[[nodiscard]] std::set<DeclaredName> declared_names(std::string_view text);

}  // namespace stanok::testing
