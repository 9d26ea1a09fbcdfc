#include "web/access/one_time_links.h"

#include <algorithm>

namespace stanok::web {

std::string OneTimeLinks::issue(Time now) {
  std::string secret = new_secret();
  if (links_.size() >= links_max) links_.pop_front();
  links_.push_back({hash_of(secret), now + valid_for});
  return secret;
}

bool OneTimeLinks::use_up(std::string_view secret, Time now) {
  std::erase_if(links_, [&](const Link& link) { return link.valid_until < now; });
  const SecretHash hash = hash_of(secret);
  return std::erase_if(links_, [&](const Link& link) { return link.hash == hash; }) > 0;
}

}  // namespace stanok::web
