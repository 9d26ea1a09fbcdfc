// The source of Boost.Beast: with BOOST_BEAST_SEPARATE_COMPILATION it is compiled here and nowhere
// else.
#include <boost/beast/src.hpp>
