// A file with one table of keys: read, checked key by key, then as a whole.
#pragma once

#include <filesystem>
#include <string>

#include "config/text/key_table.h"

namespace stanok::config {

// `content` with what the file says. `more(table, scope)` checks and reads what the keys alone do
// not tell; each stage ends when something is wrong, with all of its faults (ConfigError).
template <class Content, class More>
void read_flat_file(const std::filesystem::path& file, const Keys<Content>& keys,
                    const std::string& what, Content& content, const More& more) {
  FaultList faults;
  const auto table = parse_file(file, faults);
  faults.throw_if_any();
  const Scope scope{faults, what};
  read_table(*table, keys, content, scope);
  more(*table, scope);
  faults.throw_if_any();
}

}  // namespace stanok::config
