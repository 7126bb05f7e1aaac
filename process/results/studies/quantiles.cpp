#include "process/results/studies/quantiles.h"

#include <boost/math/distributions/chi_squared.hpp>
#include <boost/math/distributions/fisher_f.hpp>
#include <boost/math/distributions/normal.hpp>
#include <boost/math/distributions/students_t.hpp>

namespace diefill::results {

double student_95(double freedom) {
  return boost::math::quantile(boost::math::students_t(freedom), 0.975);
}

double normal_quantile(double probability) {
  return boost::math::quantile(boost::math::normal(), probability);
}

double chi_squared_exceeded(double freedom, double probability) {
  return boost::math::quantile(boost::math::complement(boost::math::chi_squared(freedom), probability));
}

double variance_ratio_exceeded(double above, double below, double probability) {
  return boost::math::quantile(boost::math::complement(boost::math::fisher_f(above, below), probability));
}

}  // namespace diefill::results
