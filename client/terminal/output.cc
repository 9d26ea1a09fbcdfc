#include "client/terminal/output.h"

#include <cstdio>

#include "base/utf8.h"

namespace stanok::client {
namespace {

void write_text_to(std::FILE* stream, std::string_view text) {
  if (is_utf8(text)) {
    std::fwrite(text.data(), 1, text.size(), stream);
  } else {
    const std::string repaired = valid_utf8(text);
    std::fwrite(repaired.data(), 1, repaired.size(), stream);
  }
}

}  // namespace

void write_data(std::string_view text) {
  write_text_to(stdout, text);
}

void write_message(std::string_view text) {
  write_text_to(stderr, text);
}

void write_data_now(std::string_view text) {
  write_data(text);
  std::fflush(stdout);
}

}  // namespace stanok::client
