// Stand-in for a header that LAMMPS' headers include and Debian's package leaves out: only the names that
// those headers need to compile. None of it is called.
#pragma once

namespace fmt {
inline namespace v7_lmp {
class string_view;
class format_args;
template <class... Args, class Format>
format_args make_args_checked(const Format&, const Args&...);
}  // namespace v7_lmp
}  // namespace fmt
