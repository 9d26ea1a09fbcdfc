// The members of a file of JSON: each is taken once by the reader of a format, and what no reader
// takes is reported as not carried.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "jobs/tools/foreign_reader.h"

namespace stanok::jobs {

using Json = nlohmann::ordered_json;

// Nothing, and a fault with its place, when the text is not JSON or is nested too deeply. `file`:
// of the text, where it is not that of the reader.
[[nodiscard]] std::optional<Json> json_of(std::string_view text, ForeignReader& reader,
                                          const std::string& file = "");

// A text that a person reads, as short as a message has room for.
[[nodiscard]] std::string shown(const Json& value);

// The text of a file.
[[nodiscard]] std::string json_file_text(const Json& value);

// The members of one object; it must outlive this.
class JsonMembers {
 public:
  // `path`: of the object in the file, "data[3].geometry"; empty: it is the file. `file`: as above.
  JsonMembers(const Json& object, std::string path, ForeignReader& reader, std::string file = "");

  [[nodiscard]] ForeignPlace place_of_member(std::string_view name) const;
  // Null: there is none. It counts as taken.
  const Json* take(std::string_view name);
  // Nothing: there is none, or it is of another kind, which is a fault.
  std::optional<double> number(std::string_view name);
  std::optional<std::string> text(std::string_view name);
  // The members of a member, empty where there is none; of another kind: a fault.
  JsonMembers object(std::string_view name);
  const Json& list(std::string_view name);

  // All that was not taken and says something, of a tool. `owner` goes before the names.
  void lose_the_rest(int tool, std::string_view reason, std::string_view owner = "");

 private:
  const Json& object_;
  std::string path_;
  std::string file_;
  ForeignReader& reader_;
  std::set<std::string, std::less<>> taken_;
};

}  // namespace stanok::jobs
