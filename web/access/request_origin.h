// Where a request comes from, as far as the browser tells: names of this server and pages of
// others.
//
// A foreign page can make a browser send requests here, with the cookie under circumstances, and a
// foreign name can be made to point here (DNS rebinding). So `Host` must be a name that this server
// has, and `Origin`, where there is one, this server itself. Ports of `Host` are not judged: they
// differ behind a tunnel.
#pragma once

#include <set>
#include <string>
#include <string_view>

namespace stanok::web {

enum class Scheme { http, https };

class OwnNames {
 public:
  // Loopback addresses and `localhost` are always its own.
  OwnNames(Scheme scheme, const std::set<std::string>& names);
  // Servers on other addresses are called by address, too: an address cannot be made to point here.
  void allow_addresses() { has_any_address_ = true; }

  [[nodiscard]] bool is_own_host(std::string_view host) const;
  // `host` is the one of the same request.
  [[nodiscard]] bool is_own_origin(std::string_view origin, std::string_view host) const;

 private:
  Scheme scheme_;
  std::set<std::string> names_;
  bool has_any_address_ = false;
};

}  // namespace stanok::web
