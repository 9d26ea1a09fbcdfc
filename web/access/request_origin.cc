#include "web/access/request_origin.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>

namespace stanok::web {
namespace {

std::string in_lower_case(std::string_view text) {
  std::string lower(text);
  std::transform(lower.begin(), lower.end(), lower.begin(), [](char letter) {
    return letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a') : letter;
  });
  return lower;
}

// "name:80", "[::1]:80" without the port; empty when the port is none.
std::string_view without_port(std::string_view host) {
  const auto behind_address = host.starts_with('[') ? host.find(']') : 0;
  if (behind_address == std::string_view::npos) return {};
  const auto colon = host.find(':', behind_address);
  if (colon == std::string_view::npos) return host;
  const auto port = host.substr(colon + 1);
  const bool is_port = !port.empty() && port.size() <= 5 &&
                       port.find_first_not_of("0123456789") == std::string_view::npos;
  return is_port ? host.substr(0, colon) : std::string_view{};
}

bool is_address(const std::string& name) {
  std::array<unsigned char, sizeof(in6_addr)> bytes{};
  if (name.starts_with('[') && name.ends_with(']'))
    return inet_pton(AF_INET6, name.substr(1, name.size() - 2).c_str(), bytes.data()) == 1;
  return inet_pton(AF_INET, name.c_str(), bytes.data()) == 1;
}

}  // namespace

OwnNames::OwnNames(Scheme scheme, const std::set<std::string>& names) : scheme_(scheme) {
  for (const std::string& name : names) names_.insert(in_lower_case(name));
  names_.insert({"localhost", "127.0.0.1", "[::1]"});
}

bool OwnNames::is_own_host(std::string_view host) const {
  const std::string name = in_lower_case(without_port(host));
  return names_.contains(name) || (has_any_address_ && is_address(name));
}

bool OwnNames::is_own_origin(std::string_view origin, std::string_view host) const {
  const std::string_view prefix = scheme_ == Scheme::https ? "https://" : "http://";
  const std::string given = in_lower_case(origin);
  return given == std::string(prefix) + in_lower_case(host);
}

}  // namespace stanok::web
