#include "polhode/real/systems.hpp"

#include <map>
#include <memory>
#include <mutex>

#include <fmt/format.h>

namespace polhode {

namespace {

/// The components' evaluators over T, made once for each precision.
template <class T>
class evaluators {
 public:
  explicit evaluators(std::vector<expression> components) : components_(std::move(components)) {}
  [[nodiscard]] std::vector<T> operator()(const std::vector<T>& x, precision p) {
    const std::shared_ptr<const list> all = at(p);
    std::vector<T> result;
    result.reserve(all->size());
    for (const auto& f : *all) result.push_back(f(std::span<const T>(x)));
    return result;
  }

 private:
  using list = std::vector<compiled_expression<T>>;
  std::shared_ptr<const list> at(precision p) {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const list>& known = by_precision_[p];
    if (known == nullptr) {
      list made;
      for (const expression& f : components_) made.push_back(f.evaluator<T>(p));
      known = std::make_shared<const list>(std::move(made));
    }
    return known;
  }
  std::vector<expression> components_;
  std::mutex mutex_;
  std::map<precision, std::shared_ptr<const list>> by_precision_;
};

precision precision_in(const std::vector<ball>& x) {
  precision p = least_precision;
  for (const ball& b : x) p = std::max(p, b.precision());
  return p;
}
precision precision_in(const std::vector<jet<ball, 1>>& x) {
  precision p = least_precision;
  for (const jet<ball, 1>& b : x) p = std::max(p, b[0].precision());
  return p;
}

}  // namespace

real_system system_of(const std::vector<expression>& components) {
  for (const expression& f : components) {
    if (f.variables().size() != components.size()) {
      throw input_error(
          fmt::format("the system has {} equations and {} variables; it must have as "
                      "many of one as of the other",
                      components.size(), f.variables().size()));
    }
  }
  struct of_both {
    std::shared_ptr<evaluators<ball>> values;
    std::shared_ptr<evaluators<jet<ball, 1>>> slopes;
    std::vector<ball> operator()(const std::vector<ball>& x) const {
      return (*values)(x, precision_in(x));
    }
    std::vector<jet<ball, 1>> operator()(const std::vector<jet<ball, 1>>& x) const {
      return (*slopes)(x, precision_in(x));
    }
  };
  return real_system(of_both{std::make_shared<evaluators<ball>>(components),
                             std::make_shared<evaluators<jet<ball, 1>>>(components)});
}

namespace detail {
std::vector<std::string> numbered_names(std::size_t count) {
  std::vector<std::string> names;
  for (std::size_t i = 1; i <= count; ++i) names.push_back("x" + std::to_string(i));
  return names;
}
}  // namespace detail

}  // namespace polhode
