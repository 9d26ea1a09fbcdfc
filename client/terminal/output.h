// What `stanok` writes: data on the standard output, messages on the standard error.
//
// Every byte of the program's output passes here and is valid UTF-8: texts of part programs, names
// of files and answers of the system may hold others, which become U+FFFD (base/utf8.h).
#pragma once

#include <string_view>

#include "protocol/json_text.h"

namespace stanok::client {

void write_data(std::string_view text);
void write_message(std::string_view text);
// Data that is shown as it comes.
void write_data_now(std::string_view text);

// One line of JSON.
template <class Json>
void write_json(const Json& value) {
  write_data(protocol::json_text(value) + "\n");
}

}  // namespace stanok::client
