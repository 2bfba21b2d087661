#include "quadrature/formula/recorded.hpp"

#include <utility>

namespace polhode {

using detail::recorded_node;
using detail::recorded_operation;
using detail::recorded_rule;

recorded recorded::argument() {
  auto nodes = std::make_shared<detail::recorded_nodes>();
  nodes->emplace_back();
  return {std::move(nodes), 0};
}

recorded recorded::added(recorded_node node) const {
  // Two balls with the same set need not be the same number.
  const bool may_repeat = node.what != kind::constant || node.exact.has_value();
  constexpr std::size_t most_compared = 2000;
  if (may_repeat && nodes_->size() <= most_compared) {
    for (std::size_t i = 1; i < nodes_->size(); ++i) {
      const recorded_node& other = (*nodes_)[i];
      if (other.what == node.what && other.left == node.left && other.right == node.right &&
          other.operation == node.operation && other.number == node.number &&
          other.exact == node.exact && (node.what != kind::constant || other.exact.has_value())) {
        return {nodes_, i};
      }
    }
  }
  nodes_->push_back(std::move(node));
  return {nodes_, nodes_->size() - 1};
}

recorded recorded::constant(const rational& q) const {
  recorded_node node;
  node.what = kind::constant;
  node.exact = q;
  return added(std::move(node));
}
recorded recorded::constant_like(const ball& x) const {
  recorded_node node;
  node.what = kind::constant;
  node.enclosure = x;
  return added(std::move(node));
}

recorded recorded::applied(const recorded_operation& op, const recorded& y, long n) const {
  recorded_node node;
  node.what = kind::function;
  node.left = node_;
  node.right = y.node_;
  node.operation = op;
  node.number = n;
  return added(std::move(node));
}

recorded recorded::piecewise(kind what, const recorded& y, const recorded& decider) const {
  recorded_node node;
  node.what = what;
  node.left = node_;
  node.right = y.node_;
  node.decider = decider.node_;
  return added(std::move(node));
}

recorded operator-(const recorded& x) {
  return x.applied(recorded_operation::analytic([](const auto& v, const auto&, long) { return -v; },
                                                recorded_rule::negative),
                   x);
}
#define POLHODE_RECORDED_OPERATOR(sign, rule)                                                \
  recorded operator sign(const recorded& x, const recorded& y) {                             \
    return x.applied(recorded_operation::analytic(                                           \
                         [](const auto& v, const auto& w, long) { return v sign w; }, rule), \
                     y);                                                                     \
  }
POLHODE_RECORDED_OPERATOR(+, recorded_rule::sum)
POLHODE_RECORDED_OPERATOR(-, recorded_rule::difference)
POLHODE_RECORDED_OPERATOR(*, recorded_rule::product)
POLHODE_RECORDED_OPERATOR(/, recorded_rule::quotient)
#undef POLHODE_RECORDED_OPERATOR

#define POLHODE_RECORDED(f, rule)                                                                  \
  recorded f(const recorded& x) {                                                                  \
    return x.applied(                                                                              \
        recorded_operation::analytic([](const auto& v, const auto&, long) { return f(v); }, rule), \
        x);                                                                                        \
  }
POLHODE_RECORDED(square, recorded_rule::square)
POLHODE_RECORDED(sqrt, recorded_rule::sqrt)
POLHODE_RECORDED(exp, recorded_rule::exp)
POLHODE_RECORDED(log, recorded_rule::other)
POLHODE_RECORDED(sin, recorded_rule::sin)
POLHODE_RECORDED(cos, recorded_rule::cos)
POLHODE_RECORDED(tan, recorded_rule::tan)
POLHODE_RECORDED(asin, recorded_rule::other)
POLHODE_RECORDED(acos, recorded_rule::other)
POLHODE_RECORDED(atan, recorded_rule::other)
POLHODE_RECORDED(sinh, recorded_rule::sinh)
POLHODE_RECORDED(cosh, recorded_rule::cosh)
POLHODE_RECORDED(tanh, recorded_rule::tanh)
POLHODE_RECORDED(asinh, recorded_rule::other)
POLHODE_RECORDED(acosh, recorded_rule::other)
POLHODE_RECORDED(atanh, recorded_rule::other)
#undef POLHODE_RECORDED

recorded pow(const recorded& x, long n) { return pow(x, rational(n)); }
recorded pow(const recorded& x, const rational& e) {
  recorded_node node;
  node.what = recorded::kind::power;
  node.left = x.node_;
  node.exact = e;
  return x.added(std::move(node));
}
recorded pow(const recorded& x, const recorded& y) {
  return x.applied(
      recorded_operation::analytic([](const auto& v, const auto& w, long) { return pow(v, w); },
                                   recorded_rule::power),
      y);
}

recorded abs(const recorded& x) { return x.piecewise(recorded::kind::abs, x, x); }
recorded floor(const recorded& x) { return x.piecewise(recorded::kind::floor, x, x); }
recorded ceil(const recorded& x) { return x.piecewise(recorded::kind::ceil, x, x); }

namespace {
bool is_zero(const recorded& x) {
  const recorded_node& node = x.nodes()[x.node()];
  return node.what == recorded_node::kind::constant && node.exact && *node.exact == 0;
}
/// x and y in an order that depends on the pair only, with a 0 as the second: so that min(x, y),
/// max(y, x) and, for y = 0, |x| change at the zeros of one and the same node.
std::pair<recorded, recorded> ordered(const recorded& x, const recorded& y) {
  const bool swap = is_zero(x) || (!is_zero(y) && y.node() < x.node());
  return swap ? std::pair(y, x) : std::pair(x, y);
}
}  // namespace

recorded min(const recorded& x, const recorded& y) {
  const auto [u, v] = ordered(x, y);
  return u.piecewise(recorded::kind::min, v, is_zero(v) ? u : u - v);
}
recorded max(const recorded& x, const recorded& y) {
  const auto [u, v] = ordered(x, y);
  return u.piecewise(recorded::kind::max, v, is_zero(v) ? u : u - v);
}

}  // namespace polhode
