// A one-time link on its way to a browser, past everybody else on this computer.
//
// What a program is started with can be read by all users while it runs, so the link stands in a
// page of mode 0600 that leads on to it, and the browser is given the name of that page. Source:
// proc(5), /proc/PID/cmdline.
#pragma once

#include <string>

namespace stanok::client {

// Whether a browser was asked to open it; what it does with the link is not known. The page is gone
// half a minute later.
[[nodiscard]] bool open_in_browser(const std::string& link);

}  // namespace stanok::client
