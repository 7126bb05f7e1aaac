// Texts with numbers in them, as printf makes them.
#pragma once

#include <string>

namespace diefill::results {

/// `format` of printf with its values filled in, "-0.00" without its sign; the compiler checks their
/// types.
[[gnu::format(printf, 1, 2)]] std::string formatted(const char* format, ...);

}  // namespace diefill::results
