// TLS as the server offers it: versions 1.2 and 1.3, with the ciphers of OpenSSL that keep old
// recordings closed.
#pragma once

#include <boost/asio/ssl/context.hpp>
#include <optional>

#include "web/server/web_options.h"

namespace stanok::web {

// Nothing: the options ask for none. Throws std::runtime_error when certificate or key cannot be
// used.
[[nodiscard]] std::optional<boost::asio::ssl::context> tls_context(const WebOptions& options);

}  // namespace stanok::web
