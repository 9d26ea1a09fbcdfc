#include "web/server/listen_address.h"

#include <boost/asio/ip/address.hpp>
#include <charconv>

namespace stanok::web {

namespace ip = boost::asio::ip;

std::optional<ip::tcp::endpoint> endpoint_of(std::string_view text) {
  const auto colon = text.rfind(':');
  if (colon == std::string_view::npos) return std::nullopt;
  std::string host(text.substr(0, colon));
  const std::string_view port_text = text.substr(colon + 1);
  unsigned short port = 0;
  const auto [end, fault] =
      std::from_chars(port_text.data(), port_text.data() + port_text.size(), port);
  if (fault != std::errc() || end != port_text.data() + port_text.size()) return std::nullopt;
  const bool is_in_brackets = host.starts_with('[') && host.ends_with(']');
  if (is_in_brackets) host = host.substr(1, host.size() - 2);
  boost::system::error_code error;
  const auto address = ip::make_address(host, error);
  if (error || address.is_v6() != is_in_brackets) return std::nullopt;
  return ip::tcp::endpoint(address, port);
}

std::string text_of(const ip::tcp::endpoint& endpoint) {
  const std::string address = endpoint.address().to_string();
  const std::string port = ':' + std::to_string(endpoint.port());
  return endpoint.address().is_v6() ? '[' + address + ']' + port : address + port;
}

}  // namespace stanok::web
