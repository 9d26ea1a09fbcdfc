#include "web/server/tls.h"

#include <stdexcept>

namespace stanok::web {

namespace ssl = boost::asio::ssl;

std::optional<ssl::context> tls_context(const WebOptions& options) {
  if (options.tls_certificate.empty()) return std::nullopt;
  ssl::context context(ssl::context::tls_server);
  context.set_options(ssl::context::default_workarounds | ssl::context::no_sslv2 |
                      ssl::context::no_sslv3 | ssl::context::no_tlsv1 | ssl::context::no_tlsv1_1 |
                      ssl::context::no_compression | SSL_OP_NO_RENEGOTIATION |
                      SSL_OP_CIPHER_SERVER_PREFERENCE);
  SSL_CTX_set_cipher_list(context.native_handle(), "ECDHE+AESGCM:ECDHE+CHACHA20");
  boost::system::error_code error;
  error = context.use_certificate_chain_file(options.tls_certificate.string(), error);
  if (error)
    throw std::runtime_error(options.tls_certificate.string() +
                             ": not a TLS certificate (PEM): " + error.message());
  error = context.use_private_key_file(options.tls_key.string(), ssl::context::pem, error);
  if (error)
    throw std::runtime_error(options.tls_key.string() +
                             ": not the key (PEM) of that certificate: " + error.message());
  return context;
}

}  // namespace stanok::web
