// Overloaded: one visitor of a variant from a lambda per alternative.
#pragma once

namespace stanok {

template <class... Handlers>
struct Overloaded : Handlers... {
  using Handlers::operator()...;
};

}  // namespace stanok
