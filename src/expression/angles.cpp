// A formula f(x) as F(x, w(x)), where F(x, w) is periodic in w: the sines, cosines and tangents of
// q w + r, numbers q and r, are the functions of w in F. There may be other variables beside x.

#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "exponential_sum.hpp"
#include "graph.hpp"
#include "polhode/expression/expression.hpp"

namespace polhode {
namespace angles_impl {
namespace {

using detail::node;
using detail::node_id;
using detail::operation;

bool is_circular(operation what) {
  return what == operation::sin || what == operation::cos || what == operation::tan ||
         what == operation::sinpi || what == operation::cospi;
}

/// q w + r, by its nodes.
struct linear_form {
  node_id w;
  node_id q;
  node_id r;
  pi_combination slope;  // the value of q, rational or a rational multiple of pi, not 0
};

class unwinding {
 public:
  /// Of a formula with so many variables.
  unwinding(detail::graph f, std::size_t variables)
      : g_(std::move(f)),
        others_(static_cast<long>(variables)),
        size_(g_.root + 1),
        varies_(detail::varying(g_)) {}

  /// One angle, and what turns with it.
  struct turning {
    node_id w;
    pi_combination period;
    std::map<node_id, linear_form> functions = {};  // by the nodes of sines, cosines and tangents
  };

  std::vector<turning> found() {
    std::vector<turning> result;
    const std::vector<char> used = detail::reachable(g_);
    for (node_id i = 0; i < size_; ++i) {
      if (used[i] == 0 || varies_[i] == 0 || !is_circular(g_[i].what)) continue;
      const linear_form form = form_of(g_[i].left, g_[i].what);
      add(result, i, form, period_of(g_[i].what, form.slope));
    }
    return result;
  }

  /// The formula with the variable w in the angle's place.
  [[nodiscard]] detail::graph in_angle(const turning& t) const {
    detail::graph to(g_.further());
    for (long k = 0; k <= others_; ++k) (void)to.variable(k);  // the first nodes, in their order
    std::map<node_id, node_id> places;
    to.root = copied(to, t, g_.root, places);
    return to;
  }
  [[nodiscard]] const detail::graph& graph() const { return g_; }

 private:
  node_id add_to(node_id x, node_id y) { return detail::add(g_, x, y); }

  node_id copied(detail::graph& to, const turning& t, node_id i,
                 std::map<node_id, node_id>& places) const {
    if (const auto known = places.find(i); known != places.end()) return known->second;
    const auto place_of = [&](node_id k) { return copied(to, t, k, places); };
    node_id place = 0;
    if (const auto turns = t.functions.find(i); turns != t.functions.end()) {
      const linear_form& form = turns->second;
      const node_id by = multiply(to, place_of(form.q), to.variable(others_));
      place = to.make(g_[i].what, detail::add(to, by, place_of(form.r)));
    } else if (const rational* number = g_.value(i)) {
      place = to.number(*number);
    } else if (g_[i].what == operation::variable) {
      place = to.variable(g_[i].number);
    } else {
      place = detail::with_operands(to, g_, i, place_of);
    }
    places.emplace(i, place);
    return place;
  }

  /// The period in w of the function of q w + r.
  static pi_combination period_of(operation what, const pi_combination& q) {
    const bool in_half_turns = what == operation::sinpi || what == operation::cospi;
    if (in_half_turns) return {abs(2 / q.q), 0};
    return q.is_rational() ? pi_combination{0, abs(2 / q.q)} : pi_combination{abs(2 / q.r), 0};
  }

  /// Joins the function to the turning of its angle with which it has a common period, or begins
  /// another one.
  static void add(std::vector<turning>& known, node_id i, const linear_form& form,
                  const pi_combination& period) {
    for (turning& t : known) {
      if (t.w != form.w) continue;
      const auto common = common_period(t.period, period);
      if (!common) continue;
      t.period = *common;
      t.functions.emplace(i, form);
      return;
    }
    known.push_back({form.w, period, {{i, form}}});
  }

  /// The argument of a function as a linear form, of the argument itself where it is no other.
  linear_form form_of(node_id argument, operation of) {
    linear_form itself{argument, g_.number(1), g_.number(0), {1, 0}};
    linear_form form = itself;
    if (const auto c = detail::polynomial_in_variable(g_, argument); c && c->size() == 2) {
      form = {g_.variable(0), (*c)[1], (*c)[0], {}};
    } else {
      while (strip(form)) continue;
    }
    const bool in_half_turns = of == operation::sinpi || of == operation::cospi;
    const auto slope = detail::known_value(g_, form.q);
    const bool is_simple =
        slope && !slope->is_zero() && (slope->is_rational() || (slope->q == 0 && !in_half_turns));
    if (!is_simple) return itself;
    form.slope = *slope;
    return form;
  }
  /// Makes (q c) v + r of q (c v) + r, q v + (q c + r) of q (v + c) + r, and -q v + (q c + r) of
  /// q (c - v) + r, for a c without a variable. Returns false where w is no such sum or product.
  bool strip(linear_form& form) {
    const node n = g_[form.w];
    const auto is_number = [this](node_id i) { return varies_[i] == 0; };
    const auto scale = [&](node_id v, node_id by) {
      form = {v, multiply(g_, form.q, by), form.r, {}};
      return true;
    };
    const auto shift = [&](node_id v, node_id by) {
      form = {v, form.q, add_to(form.r, multiply(g_, form.q, by)), {}};
      return true;
    };
    switch (n.what) {
      case operation::negate:
        return scale(n.left, g_.number(-1));
      case operation::multiply:
        if (is_number(n.left)) return scale(n.right, n.left);
        return is_number(n.right) && scale(n.left, n.right);
      case operation::divide:
        return is_number(n.right) && scale(n.left, divide(g_, g_.number(1), n.right));
      case operation::add:
        if (is_number(n.left)) return shift(n.right, n.left);
        return is_number(n.right) && shift(n.left, n.right);
      case operation::subtract:
        if (is_number(n.right)) return shift(n.left, negate(g_, n.right));
        if (!is_number(n.left)) return false;
        shift(n.right, n.left);
        form.q = negate(g_, form.q);
        return true;
      default:
        return false;
    }
  }

  detail::graph g_;
  long others_;  // variables beside the angle
  node_id size_;
  std::vector<char> varies_;
};

}  // namespace
}  // namespace angles_impl

std::vector<expression::unwound> expression::unwound_angles() const {
  constexpr detail::node_id most_nodes = 500;
  if (variables_.empty() || graph_->root >= most_nodes) return {};
  expression with_angle(*this);
  with_angle.variables_.push_back(variables_.front() + "_angle");
  angles_impl::unwinding f(*graph_, variables_.size());
  std::vector<unwound> result;
  try {
    for (const auto& turning : f.found()) {
      detail::graph in_angle = f.in_angle(turning);
      const detail::node_id root = in_angle.root;
      result.push_back({with_root(f.graph(), turning.w), turning.period,
                        with_angle.with_root(std::move(in_angle), root)});
    }
  } catch (const detail::undefined_operation&) {
    return {};  // an operation has no value anywhere
  }
  return result;
}

}  // namespace polhode
