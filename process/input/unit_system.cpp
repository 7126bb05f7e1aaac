#include "process/input/unit_system.h"

#include <cstdarg>
#include <stdexcept>
#include <string_view>

namespace diefill::process {
namespace {

struct FreeSystem {
  void operator()(ut_system* system) const { ut_free_system(system); }
};

/// udunits2 prints errors itself; the user should see one line, in the program's own words.
int say_nothing(const char*, va_list) {
  return 0;
}

UnitMakeup& makeup(void* argument) {
  return *static_cast<UnitMakeup*>(argument);
}

bool is_angle(const ut_unit* unit) {
  const char* symbol = ut_get_symbol(unit, UT_ASCII);
  return symbol != nullptr && std::string_view(symbol) == "rad";
}

ut_status visit_basic(const ut_unit* unit, void* found) {
  makeup(found).angle = is_angle(unit) ? 1 : 0;
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit*, int count, const ut_unit* const* units, const int* powers,
                        void* found) {
  for (int k = 0; k < count; ++k)
    if (is_angle(units[k])) makeup(found).angle += powers[k];
  makeup(found).pure_number = count == 0;
  return UT_SUCCESS;
}

ut_status visit_galilean(const ut_unit*, double, const ut_unit* underlying, double offset, void* found) {
  makeup(found) = makeup_of(underlying);
  if (offset != 0) makeup(found).proportional = false;
  return UT_SUCCESS;
}

ut_status visit_timestamp(const ut_unit*, const ut_unit*, double, void* found) {
  makeup(found).proportional = false;
  return UT_SUCCESS;
}

ut_status visit_logarithmic(const ut_unit*, double, const ut_unit*, void* found) {
  makeup(found).proportional = false;
  return UT_SUCCESS;
}

}  // namespace

ut_system* unit_system() {
  static const std::unique_ptr<ut_system, FreeSystem> system = [] {
    ut_set_error_message_handler(say_nothing);
    std::unique_ptr<ut_system, FreeSystem> made(ut_read_xml(nullptr));
    if (!made)
      throw std::runtime_error("cannot read the unit database of udunits2; install libudunits2-data");
    const Unit degree(ut_parse(made.get(), "degree", UT_UTF8));
    ut_map_name_to_unit("deg", UT_UTF8, degree.get());
    return made;
  }();
  return system.get();
}

UnitMakeup makeup_of(const ut_unit* unit) {
  static const ut_visitor visitor = {visit_basic, visit_product, visit_galilean, visit_timestamp,
                                     visit_logarithmic};
  UnitMakeup found;
  ut_accept_visitor(unit, &visitor, &found);
  return found;
}

}  // namespace diefill::process
