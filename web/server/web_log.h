// What the server says goes to standard error, with the time unless a journal adds it.
#pragma once

namespace stanok::web {

void log_to_standard_error();

}  // namespace stanok::web
