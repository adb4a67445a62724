// Boost asks programs that are built without exceptions to say what happens instead. Its integers would only
// throw on a division by zero, which no caller does. Weak: a program that has its own keeps it.
#include <boost/config.hpp>

#ifdef BOOST_NO_EXCEPTIONS
#include <boost/assert/source_location.hpp>
#include <cstdlib>
#include <exception>

namespace boost {

[[gnu::weak, noreturn]] void throw_exception(const std::exception&);
[[gnu::weak, noreturn]] void throw_exception(const std::exception&, const source_location&);

void throw_exception(const std::exception&) { std::abort(); }
void throw_exception(const std::exception&, const source_location&) { std::abort(); }

}  // namespace boost
#endif
