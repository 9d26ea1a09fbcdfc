#include "web/access/login_turns.h"

#include <algorithm>
#include <utility>

namespace stanok::web {

std::optional<LoginTurns::Entered> LoginTurns::enter(const Claimant& claimant) {
  if (!present_.insert(claimant).second) return std::nullopt;
  places_[claimant.place].push_back({++last_ticket_, claimant});
  ++waiting_;
  return Entered{.ticket = last_ticket_, .pushed_out = make_room()};
}

std::optional<LoginTurns::Ticket> LoginTurns::make_room() {
  if (waiting_ <= waiting_max) return std::nullopt;
  const auto fullest = std::max_element(
      places_.begin(), places_.end(),
      [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
  const Waiting out = std::move(fullest->second.back());
  fullest->second.pop_back();
  if (fullest->second.empty()) places_.erase(fullest);
  present_.erase(out.claimant);
  --waiting_;
  return out.ticket;
}

std::optional<LoginTurns::Ticket> LoginTurns::next() {
  if (called_ || places_.empty()) return std::nullopt;
  auto place = places_.upper_bound(last_place_);
  if (place == places_.end()) place = places_.begin();
  last_place_ = place->first;
  called_ = std::move(place->second.front());
  place->second.pop_front();
  if (place->second.empty()) places_.erase(place);
  --waiting_;
  return called_->ticket;
}

void LoginTurns::leave() {
  if (called_) present_.erase(called_->claimant);
  called_.reset();
}

}  // namespace stanok::web
