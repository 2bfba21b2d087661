#include <algorithm>
#include <array>

#include "rules.hpp"

namespace polhode {

namespace {

template <const panel_rule& (*rule)()>
const quadrature_strategy& as_strategy() {
  return rule();
}

}  // namespace

constinit const quadrature_rule quadrature_rule::automatic{maker{nullptr}};
constinit const quadrature_rule quadrature_rule::antiderivative{maker{detail::antiderivative_rule}};
constinit const quadrature_rule quadrature_rule::turned_rays{maker{detail::turned_rays_rule}};
constinit const quadrature_rule quadrature_rule::taylor_series{maker{detail::taylor_series_rule}};
constinit const quadrature_rule quadrature_rule::gauss_legendre{
    maker{as_strategy<detail::gauss_legendre_panels>}};
constinit const quadrature_rule quadrature_rule::double_exponential{
    maker{detail::double_exponential_rule}};
constinit const quadrature_rule quadrature_rule::clenshaw_curtis{
    maker{as_strategy<detail::clenshaw_curtis_panels>}};
constinit const quadrature_rule quadrature_rule::trapezoid{maker{detail::trapezoid_rule}};

std::span<const quadrature_rule> quadrature_rule::all() {
  static const std::array rules{antiderivative,     turned_rays,     taylor_series, gauss_legendre,
                                double_exponential, clenshaw_curtis, trapezoid};
  return rules;
}

std::optional<quadrature_rule> quadrature_rule::named(std::string_view word) {
  if (word == automatic.word()) return automatic;
  const auto rule = std::ranges::find(all(), word, &quadrature_rule::word);
  return rule == all().end() ? std::nullopt : std::optional(*rule);
}

std::string quadrature_rule::name() const {
  return is_automatic() ? "automatic" : std::string(strategy()->name());
}

std::string quadrature_rule::word() const {
  std::string word = name();
  std::ranges::transform(word, word.begin(), [](char c) {
    if (c == ' ') return '-';
    return 'A' <= c && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return word;
}

std::string to_text(const quadrature_rule& rule) { return rule.name(); }

}  // namespace polhode
