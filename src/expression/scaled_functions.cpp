// Products in which functions that grow or decay exponentially meet exponentials that undo it,
// written by scaled functions: with F(x) = exp(s(x)) G(x), each factor F^k as G^k, and one
// exponential of the sum of the k s(x) and of the exponents that are there. Over sets of large x
// exp(x) E_1(x) is a product of huge sets and tiny ones; e^x E_1(x) is about 1/x.

#include <cstdlib>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "calls.hpp"
#include "exact_value.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace scaled_functions_impl {
namespace {

using detail::further_call;
using detail::graph;
using detail::node;
using detail::node_id;
using detail::operation;

constexpr node_id most_nodes = 300;

/// A sum of rational multiples of nodes.
using linear_sum = std::map<node_id, rational>;

/// A function as exp(exponent) times `scaled`.
struct scaled_form {
  linear_sum exponent;
  node_id scaled;
};

/// A factor of a product, and how often it occurs there.
struct factor {
  node_id what;
  long times;
};

constexpr long most_times = 1000;
/// The walks through exponents, along all paths, that a formula may take.
constexpr long most_steps = 100'000;
struct too_long {};

class scaling {
 public:
  explicit scaling(graph f) : g_(std::move(f)), size_(g_.root + 1), varies_(detail::varying(g_)) {}

  /// Nothing where there is no such product.
  std::optional<node_id> result() {
    const auto* further = g_.further().get();
    if (further == nullptr || !detail::has_further(further, "besselIx")) return std::nullopt;
    values_.resize(size_);
    for (node_id i = 0; i < size_; ++i) {
      if (varies_[i] == 0 || g_[i].what == operation::variable) {
        values_[i] = i;
        continue;
      }
      const std::optional<node_id> product = is_product(i) ? scaled_product(i) : std::nullopt;
      values_[i] = product
                       ? *product
                       : detail::with_operands(g_, g_, i, [&](node_id k) { return values_[k]; });
      has_changed_ = has_changed_ || product;
    }
    return has_changed_ ? std::optional(values_[g_.root]) : std::nullopt;
  }
  [[nodiscard]] const detail::graph& graph_of_result() const { return g_; }

 private:
  [[nodiscard]] bool varies(node_id i) const { return i < size_ && varies_[i] != 0; }
  [[nodiscard]] bool is_product(node_id i) const {
    const operation what = g_[i].what;
    return what == operation::multiply || what == operation::divide ||
           what == operation::power_integer;
  }

  /// The rational number that a node is; nothing where that is not known.
  std::optional<rational> rational_at(node_id i) {
    if (const rational* q = g_.value(i)) return *q;
    return varies(i) ? std::nullopt : detail::rational_value_at(g_, i);
  }

  // -----------------------------------------------------------------------------------------------
  // Domains
  //
  // Exponents that cancel leave nothing of what they are made of: exp(x + log(5-x)) times
  // exp(-log(5-x)) would be exp(x), which is defined beyond 5. So exponents are taken where they
  // are shown to be defined for all x > 0. The arguments of the other functions stay in the scaled
  // ones.

  void count_step() {
    if (++steps_ > most_steps) throw too_long();
  }
  bool is_positive(node_id i) {
    count_step();
    if (!varies(i)) return certainly_positive(detail::value_at(g_, i, 64));
    const node n = g_[i];
    switch (n.what) {
      case operation::variable:
        return true;
      case operation::add:
      case operation::multiply:
      case operation::divide:
        return is_positive(n.left) && is_positive(n.right);
      case operation::power:
        return is_positive(n.left) && is_defined(n.right);
      case operation::power_integer:
      case operation::root:
      case operation::sqrt:
        return is_positive(n.left);
      case operation::exp:
      case operation::cosh:
        return is_defined(n.left);
      default:
        return false;
    }
  }
  bool is_defined(node_id i) {
    count_step();
    if (!varies(i)) return detail::value_at(g_, i, 64).is_bounded();
    if (is_positive(i)) return true;
    const node n = g_[i];
    switch (n.what) {
      case operation::negate:
      case operation::sin:
      case operation::cos:
      case operation::sinh:
      case operation::tanh:
      case operation::atan:
        return is_defined(n.left);
      case operation::log:
        return is_positive(n.left);
      case operation::add:
      case operation::subtract:
      case operation::multiply:
        return is_defined(n.left) && is_defined(n.right);
      case operation::divide:
        return is_defined(n.left) && is_positive(n.right);
      case operation::power_integer:
        return n.number >= 0 && is_defined(n.left);
      default:
        return false;
    }
  }

  // -----------------------------------------------------------------------------------------------
  // Exponents

  void add_to(linear_sum& sum, node_id i, const rational& times) {
    count_step();
    const node n = g_[i];
    switch (n.what) {
      case operation::negate:
        return add_to(sum, n.left, -times);
      case operation::add:
      case operation::subtract:
        add_to(sum, n.left, times);
        return add_to(sum, n.right, n.what == operation::add ? times : rational(-times));
      case operation::multiply:
        if (const auto q = rational_at(n.left)) return add_to(sum, n.right, times * *q);
        if (const auto q = rational_at(n.right)) return add_to(sum, n.left, times * *q);
        break;
      case operation::divide:
        if (const auto q = rational_at(n.right); q && *q != 0) {
          return add_to(sum, n.left, times / *q);
        }
        break;
      default:
        break;
    }
    rational& total = sum[i];
    total += times;
    if (total == 0) sum.erase(i);
  }
  static void add_to(linear_sum& sum, const linear_sum& other, long times) {
    for (const auto& [i, q] : other) {
      rational& total = sum[i];
      total += times * q;
      if (total == 0) sum.erase(i);
    }
  }
  node_id node_of(const linear_sum& sum) {
    node_id result = g_.number(0);
    for (const auto& [i, q] : sum) {
      const node_id term = q == 1 ? i : multiply(g_, g_.number(q), i);
      result = add(g_, result, term);
    }
    return result;
  }
  /// 1 or -1 where the sum seems to tend to infinity or minus infinity; 0 where it does not.
  int direction(const linear_sum& sum) {
    if (sum.empty()) return 0;
    constexpr long far = 32;
    const ball value = detail::value_far_out(g_, node_of(sum));
    return certainly_less(ball(far, 64), value)    ? 1
           : certainly_less(value, ball(-far, 64)) ? -1
                                                   : 0;
  }

  /// x^2 of an x > 0, where x may be a constant times a root.
  void add_square(linear_sum& sum, node_id x, const rational& times) {
    const node n = g_[x];
    if (n.what == operation::negate) return add_square(sum, n.left, times);
    if (n.what == operation::sqrt) return add_to(sum, n.left, times);
    if (n.what == operation::multiply || n.what == operation::divide) {
      const bool is_left = n.what == operation::multiply && !varies(n.left);
      const node_id constant = is_left ? n.left : n.right;
      const auto square =
          varies(constant) ? std::nullopt : rational_at(multiply(g_, constant, constant));
      if (square && *square != 0) {
        return add_square(
            sum, is_left ? n.right : n.left,
            n.what == operation::divide ? rational(times / *square) : rational(times * *square));
      }
    }
    add_to(sum, power(g_, x, g_.number(2)), times);
  }

  // -----------------------------------------------------------------------------------------------
  // Functions

  node_id call(const char* name, const std::vector<node_id>& operands) {
    const further_function* f = detail::find_further(g_.further().get(), name, operands.size());
    return detail::call_further(g_, *f, operands);
  }

  node_id function_of(const char* name, node_id x) {
    return detail::find_function(name)->build(g_, {x});
  }

  /// exp(u); for u that grows, cosh(u) and sinh(u) = exp(u) (1 +- exp(-2 u))/2.
  std::optional<scaled_form> exponential(node_id i) {
    const node n = g_[i];
    scaled_form result;
    const bool is_one =
        n.what == operation::exp || n.what == operation::sinh || n.what == operation::cosh;
    if (!is_one || !is_defined(n.left)) return std::nullopt;
    if (n.what == operation::exp) {
      add_to(result.exponent, n.left, 1);
      result.scaled = g_.number(1);
      return result;
    }
    add_to(result.exponent, n.left, 1);
    if (direction(result.exponent) <= 0) return std::nullopt;
    const node_id square = function_of("exp", multiply(g_, g_.number(-2), value_of(n.left)));
    const node_id twice = n.what == operation::cosh ? add(g_, g_.number(1), square)
                                                    : subtract(g_, g_.number(1), square);
    result.scaled = divide(g_, twice, g_.number(2));
    return result;
  }

  /// erfc(x) = exp(-x^2) erfcx(x), erfi(x) = 2/sqrt(pi) exp(x^2) dawson(x) and, for x > 0,
  /// gammaUpper(s, x) = x^s exp(-x) expintx(1 - s, x) (DLMF 8.19.1); the others by their
  /// definition.
  std::optional<scaled_form> scaled(node_id i) {
    const node n = g_[i];
    const auto of_error_function = [&](node_id x) {
      scaled_form result;
      add_square(result.exponent, x, -1);
      result.scaled = call("erfcx", {value_of(x)});
      return result;
    };
    if (n.what == operation::erfc) return of_error_function(n.left);
    if (n.what == operation::subtract && g_[n.right].what == operation::erf) {
      const rational* one = g_.value(n.left);
      if (one != nullptr && *one == 1) return of_error_function(g_[n.right].left);
    }
    if (n.what != operation::further) return std::nullopt;
    const further_call& f = g_.call_at(i);
    const std::string_view name = f.function->what.name;
    if (name == "erfi") {
      const node_id x = f.operands[0];
      scaled_form result;
      add_square(result.exponent, x, 1);
      const node_id root = function_of("sqrt", detail::find_constant("pi")->build(g_));
      result.scaled = divide(g_, multiply(g_, g_.number(2), call("dawson", {value_of(x)})), root);
      return result;
    }
    if (f.operands.size() != 2 || varies(f.operands[0])) return std::nullopt;
    const node_id order = f.operands[0];
    const node_id x = f.operands[1];
    const auto by = [&](const char* scaled_name, long sign) {
      scaled_form result;
      add_to(result.exponent, x, sign);
      result.scaled = call(scaled_name, {order, value_of(x)});
      return result;
    };
    if (name == "besselI") return by("besselIx", 1);
    if (name == "besselK") return by("besselKx", -1);
    if (name == "expint") return by("expintx", -1);
    if (name == "gammaUpper") {
      scaled_form result;
      add_to(result.exponent, x, -1);
      const node_id other = subtract(g_, g_.number(1), order);
      result.scaled =
          multiply(g_, power(g_, value_of(x), order), call("expintx", {other, value_of(x)}));
      return result;
    }
    return std::nullopt;
  }
  /// An operand of the formula as it is written now.
  [[nodiscard]] node_id value_of(node_id i) const { return i < size_ ? values_[i] : i; }

  // -----------------------------------------------------------------------------------------------
  // Products

  /// The factors of a product; false where there are too many.
  bool collect(std::vector<factor>& factors, node_id i, long times) {
    const node n = g_[i];
    constexpr std::size_t most_factors = 100;
    if (factors.size() >= most_factors || std::abs(times) > most_times) return false;
    switch (n.what) {
      case operation::negate:
        factors.push_back({g_.number(-1), times});
        return collect(factors, n.left, times);
      case operation::multiply:
        return collect(factors, n.left, times) && collect(factors, n.right, times);
      case operation::divide:
        return collect(factors, n.left, times) && collect(factors, n.right, -times);
      case operation::power_integer:
        if (std::abs(n.number) > most_times || n.number == 0) break;
        return collect(factors, n.left, times * n.number);
      default:
        break;
    }
    factors.push_back({i, times});
    return true;
  }

  std::optional<node_id> scaled_product(node_id i) {
    std::vector<factor> factors;
    if (!collect(factors, i, 1)) return std::nullopt;
    linear_sum exponent;
    std::vector<factor> rest;
    bool has_function = false;
    bool grows = false;
    for (const factor& f : factors) {
      std::optional<scaled_form> form = scaled(f.what);
      has_function = has_function || form;
      if (!form && varies(f.what)) form = exponential(f.what);
      if (!form) {
        rest.push_back({value_of(f.what), f.times});
        continue;
      }
      linear_sum own;
      add_to(own, form->exponent, f.times);
      grows = grows || direction(own) > 0;
      add_to(exponent, own, 1);
      rest.push_back({form->scaled, f.times});
    }
    if (!has_function || !grows || direction(exponent) > 0) return std::nullopt;
    node_id result = g_.number(1);
    for (const factor& f : rest) {
      const node_id size = power(g_, f.what, g_.number(std::abs(f.times)));
      result = f.times > 0 ? multiply(g_, result, size) : divide(g_, result, size);
    }
    if (exponent.empty()) return result;
    return multiply(g_, function_of("exp", node_of(exponent)), result);
  }

  graph g_;
  node_id size_;
  std::vector<char> varies_;
  std::vector<node_id> values_;
  bool has_changed_ = false;
  long steps_ = 0;
};

}  // namespace
}  // namespace scaled_functions_impl

std::optional<expression> expression::with_scaled_functions() const {
  if (variables_.size() != 1 || graph_->root >= scaled_functions_impl::most_nodes) {
    return std::nullopt;
  }
  try {
    scaled_functions_impl::scaling f(*graph_);
    const auto found = f.result();
    return found ? std::optional(with_root(f.graph_of_result(), *found)) : std::nullopt;
  } catch (const detail::undefined_operation&) {
    return std::nullopt;  // an operation has no value anywhere
  } catch (const scaled_functions_impl::too_long&) {
    return std::nullopt;
  }
}

}  // namespace polhode
