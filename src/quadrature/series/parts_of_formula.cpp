#include <algorithm>
#include <memory>
#include <utility>

#include "parts_by_variable.hpp"
#include "quadrature/formula/formula_graph.hpp"

namespace polhode::detail {

namespace {

class parts_of {
 public:
  parts_of(const formula_graph& f, const end_point& a, const end_point& b) : f_(f), a_(a), b_(b) {
    for (std::size_t i = 0; i < f.size() && !plain_; ++i) {
      if (f.node(i).is_exponential() || f.node(i).is_circular()) {
        plain_ = std::make_unique<forms>(f, f.result(), argument_itself(f, 1, 0, nullptr));
      }
    }
  }

  [[nodiscard]] std::optional<std::vector<hyperexponential_integral>> of(std::size_t node) {
    std::vector<hyperexponential_integral> result;
    if (!plain_) {
      if (!add_in_argument({f_, a_, b_}, node, result)) return in_sum(node);
      return result;
    }
    for (const auto add_in :
         {&add_in_argument, &add_in_exponential, &add_in_sine_squared, &add_in_sine_of_half}) {
      result.clear();
      if (add_in({f_, a_, b_, plain_.get()}, node, result)) return result;
    }
    return in_sum(node);
  }

 private:
  [[nodiscard]] bool is_sum(std::size_t node) const {
    const operation what = f_.node(node).what;
    return what == operation::add || what == operation::subtract;
  }
  /// Of the sum that a node is; no more than a few over the most.
  [[nodiscard]] std::size_t terms_of(std::size_t node) const {
    std::vector<std::size_t> open{node};
    std::size_t terms = 0;
    while (!open.empty() && terms <= most_terms && open.size() <= most_terms) {
      const std::size_t next = open.back();
      open.pop_back();
      if (is_sum(next)) {
        open.push_back(f_.node(next).left);
        open.push_back(f_.node(next).right);
      } else {
        ++terms;
      }
    }
    return terms + open.size();
  }
  /// A sum term by term.
  [[nodiscard]] std::optional<hyperexponential_integrals> in_sum(std::size_t node) {
    const formula_node& sum_node = f_.node(node);
    const auto rule = sum_node.what;
    if (!is_sum(node) || terms_of(node) > most_terms) return std::nullopt;
    auto left = of(sum_node.left);
    if (!left) return std::nullopt;
    auto right = of(sum_node.right);
    if (!right || left->size() + right->size() > most_terms) return std::nullopt;
    for (hyperexponential_integral& part : *right) {
      if (rule == operation::subtract) {
        part.function.coefficient = -part.function.coefficient;
      }
      left->push_back(std::move(part));
    }
    return left;
  }

  const formula_graph& f_;
  const end_point& a_;
  const end_point& b_;
  /// What nodes are in x, where the formula has exponential or circular functions of them.
  std::unique_ptr<forms> plain_;
};

}  // namespace

std::optional<std::vector<hyperexponential_integral>> hyperexponential_parts(const formula_graph& f,
                                                                             const end_point& a,
                                                                             const end_point& b) {
  constexpr std::size_t most_nodes = 2000;  // the polynomials of longer ones are long, too
  if (f.has_breaks() || f.size() > most_nodes) return std::nullopt;
  return parts_of(f, a, b).of(f.result());
}

}  // namespace polhode::detail
