#include "client/terminal/output.h"

#include <unistd.h>

#include <cstdio>

#include "base/utf8.h"
#include "client/terminal/screen_text.h"
#include "client/terminal/terminal.h"

namespace stanok::client {
namespace {

void write_to(std::FILE* stream, std::string_view text) {
  if (is_utf8(text)) {
    std::fwrite(text.data(), 1, text.size(), stream);
  } else {
    const std::string repaired = valid_utf8(text);
    std::fwrite(repaired.data(), 1, repaired.size(), stream);
  }
}

// What is visible, between colours.
void show_on(const Terminal& terminal, std::FILE* stream, std::string_view text) {
  while (!text.empty()) {
    const std::size_t colour = terminal.next_colour(text);
    write_to(stream, visible(text.substr(0, colour)));
    text.remove_prefix(colour);
    const std::size_t length = terminal.colour_length(text);
    std::fwrite(text.data(), 1, length, stream);
    text.remove_prefix(length);
  }
}

void write_text_to(std::FILE* stream, const Terminal& terminal, std::string_view text) {
  if (terminal.is_terminal()) {
    show_on(terminal, stream, text);
  } else {
    write_to(stream, text);
  }
}

}  // namespace

void write_data(std::string_view text) {
  static const Terminal terminal(STDOUT_FILENO);
  write_text_to(stdout, terminal, text);
}

void write_message(std::string_view text) {
  static const Terminal terminal(STDERR_FILENO);
  write_text_to(stderr, terminal, text);
}

void write_data_now(std::string_view text) {
  write_data(text);
  std::fflush(stdout);
}

void write_data_with_orders(std::string_view text) {
  write_to(stdout, text);
  std::fflush(stdout);
}

void write_message_with_orders(std::string_view text) {
  write_to(stderr, text);
}

}  // namespace stanok::client
