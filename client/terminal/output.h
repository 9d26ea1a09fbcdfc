// What `stanok` writes: data on the standard output, messages on the standard error.
//
// Every byte of the program's output passes here and is valid UTF-8: texts of part programs, names
// of files and answers of the system may hold others, which become U+FFFD (base/utf8.h). On a
// terminal their control characters are shown and never sent (screen_text.h): orders of our own are
// colours of Terminal, in texts, and what is written `with_orders`.
#pragma once

#include <string_view>

#include "protocol/contract/json_text.h"

namespace stanok::client {

void write_data(std::string_view text);
void write_message(std::string_view text);
// Data that is shown as it comes.
void write_data_now(std::string_view text);
// Text with orders for a terminal, to erase or go back: what it has from elsewhere is made visible
// before. Shown as it comes.
void write_data_with_orders(std::string_view text);
void write_message_with_orders(std::string_view text);

// One line of JSON.
template <class Json>
void write_json(const Json& value) {
  write_data(protocol::json_text(value) + "\n");
}

}  // namespace stanok::client
