#include "process/calibration/methods/minimise.h"

#include <nlopt.h>

#include <cmath>
#include <exception>
#include <memory>
#include <stdexcept>

namespace diefill::process::calibration {
namespace {

constexpr double kWorst = 1e100;

/// What NLopt calls through a plain pointer; an exception must not pass through its C code.
struct Call {
  const Objective& objective;
  nlopt_opt optimiser = nullptr;
  std::exception_ptr failure = {};
  Minimum best = {};
};

double evaluate(unsigned count, const double* x, double*, void* data) {
  Call& call = *static_cast<Call*>(data);
  try {
    const Eigen::VectorXd point = Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(count));
    const double value = call.objective(point);
    const double finite = std::isfinite(value) ? value : kWorst;
    if (call.best.at.size() == 0 || finite < call.best.value) call.best = {point, finite};
    return finite;
  } catch (...) {
    call.failure = std::current_exception();
    nlopt_force_stop(call.optimiser);
    return kWorst;
  }
}

struct Destroy {
  void operator()(nlopt_opt optimiser) const { nlopt_destroy(optimiser); }
};

Minimum minimum_by(nlopt_algorithm algorithm, const Objective& objective, const Eigen::VectorXd& start,
                   const Eigen::VectorXd& lower, const Eigen::VectorXd& upper, int evaluations) {
  const std::unique_ptr<nlopt_opt_s, Destroy> optimiser(
      nlopt_create(algorithm, static_cast<unsigned>(lower.size())));
  if (!optimiser) throw std::runtime_error("NLopt has no such algorithm");
  Call call{objective, optimiser.get()};
  nlopt_set_lower_bounds(optimiser.get(), lower.data());
  nlopt_set_upper_bounds(optimiser.get(), upper.data());
  nlopt_set_min_objective(optimiser.get(), evaluate, &call);
  nlopt_set_maxeval(optimiser.get(), evaluations);
  nlopt_set_xtol_rel(optimiser.get(), 1e-6);
  Eigen::VectorXd at = start;
  double value = 0;
  const nlopt_result end = nlopt_optimize(optimiser.get(), at.data(), &value);
  if (call.failure) std::rethrow_exception(call.failure);
  // Limits of rounding stop it at a place that is good enough.
  if (end < 0 && end != NLOPT_ROUNDOFF_LIMITED)
    throw std::runtime_error("NLopt stopped with code " + std::to_string(end));
  return call.best;
}

}  // namespace

Minimum minimum_near(const Objective& objective, const Eigen::VectorXd& start, const Eigen::VectorXd& lower,
                     const Eigen::VectorXd& upper, int evaluations) {
  return minimum_by(NLOPT_LN_SBPLX, objective, start.cwiseMax(lower).cwiseMin(upper), lower, upper,
                    evaluations);
}

Minimum minimum_in_box(const Objective& objective, const Eigen::VectorXd& lower, const Eigen::VectorXd& upper,
                       int evaluations) {
  const Minimum coarse =
      minimum_by(NLOPT_GN_DIRECT_L, objective, 0.5 * (lower + upper), lower, upper, evaluations);
  return minimum_near(objective, coarse.at, lower, upper, evaluations);
}

}  // namespace diefill::process::calibration
