// Stand-in for a header that LAMMPS' headers include and Debian's package leaves out: the names that they
// need to be read. Nothing of it is called.
#pragma once

namespace fmt {
inline namespace v7_lmp {
class string_view;
class format_args;
template <class... Args, class Format>
format_args make_args_checked(const Format&, const Args&...);
}  // namespace v7_lmp
}  // namespace fmt
