// Expected<T, E>: a value or the reason why there is none, with the names of std::expected (C++23).
#pragma once

#include <tl/expected.hpp>

namespace stanok {

template <class Value, class Error>
using Expected = tl::expected<Value, Error>;

template <class Error>
using Unexpected = tl::unexpected<Error>;

}  // namespace stanok
