// The address that the server listens on: "127.0.0.1:8080", "[::1]:8080"; port 0 takes a free one.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace stanok::web {

// Nothing: it is no address with a port. Names are none: what they mean is for others to say.
[[nodiscard]] std::optional<boost::asio::ip::tcp::endpoint> endpoint_of(std::string_view text);
[[nodiscard]] std::string text_of(const boost::asio::ip::tcp::endpoint& endpoint);

}  // namespace stanok::web
