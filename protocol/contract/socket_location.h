// Where the operator socket of a machine stands, the same for daemon and client.
//
// `$XDG_RUNTIME_DIR/stanok/NAME.sock`, or, without that variable, `NAME.sock` in the state
// directory of the machine; the state directory is `$STATE_DIRECTORY` (set by systemd) or
// `$XDG_STATE_HOME/stanok/NAME`
// (`~/.local/state/stanok/NAME`).
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "base/expected.h"

namespace stanok::protocol {

[[nodiscard]] std::filesystem::path default_state_directory(std::string_view machine);

[[nodiscard]] std::filesystem::path default_socket(std::string_view machine,
                                                   const std::filesystem::path& state_directory);

// Sockets of all machines of this user, sorted; whether a daemon answers there is not known.
[[nodiscard]] std::vector<std::filesystem::path> known_sockets();

// The socket to use: the one named, else $STANOK_SOCKET, else the only one there is. The error:
// there is none, or more than one.
[[nodiscard]] Expected<std::filesystem::path, std::string> chosen_socket(
    const std::filesystem::path& named);

// Where `stanok-web` gives out links to its page: beside the socket of the daemon that it shows.
[[nodiscard]] std::filesystem::path link_socket(const std::filesystem::path& socket);

}  // namespace stanok::protocol
