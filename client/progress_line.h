// One line on standard error that goes away before anything else is printed; nothing where that is
// no terminal.
#pragma once

#include <unistd.h>

#include <string>

#include "client/output.h"
#include "client/terminal.h"

namespace stanok::client {

class ProgressLine {
 public:
  void show(const std::string& text) const {
    if (!terminal_.is_terminal()) return;
    write_message("\r\033[K" + text);  // ECMA-48 EL: erase to the end of the line
  }
  void clear() const { show(""); }

 private:
  Terminal terminal_{STDERR_FILENO};
};

}  // namespace stanok::client
