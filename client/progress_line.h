// One line on standard error that goes away before anything else is printed; nothing where that is
// no terminal.
#pragma once

#include <unistd.h>

#include <cstdio>
#include <string>

#include "client/terminal.h"

namespace stanok::client {

class ProgressLine {
 public:
  void show(const std::string& text) const {
    if (!terminal_.is_terminal()) return;
    std::fprintf(stderr, "\r\033[K%s", text.c_str());  // ECMA-48 EL: erase to the end of the line
    std::fflush(stderr);
  }
  void clear() const { show(""); }

 private:
  Terminal terminal_{STDERR_FILENO};
};

}  // namespace stanok::client
