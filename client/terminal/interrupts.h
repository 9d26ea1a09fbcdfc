// Ctrl-C and SIGTERM, noted instead of ending the process: a command ends in order by itself.
#pragma once

namespace stanok::client {

// From now on SIGINT and SIGTERM are noted; system calls that wait return with EINTR.
void catch_interrupts();
[[nodiscard]] bool is_interrupted();

}  // namespace stanok::client
